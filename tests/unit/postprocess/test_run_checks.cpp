// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/run_checks.h"
#include "core/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace encased_column;

namespace {

// 20 % strain, everything as it should be.
ShearRecord good_record()
{
  ShearRecord record;
  record.target_confining_stress = 100e3;
  record.unbalanced_kind = "average";
  for (int i = 0; i <= 400; ++i) {
    record.axial_strain.push_back(0.0005 * i);
    record.confining_stress.push_back(100e3);
    record.stress_top.push_back(300e3);
    record.stress_bottom.push_back(300e3);
    record.unbalanced_ratio.push_back(9e-6);
    record.inertial_number.push_back(2e-4);
    record.energy_error.push_back(-0.001);
  }
  return record;
}

std::vector<std::string> failures(const ShearRecord& record)
{
  std::vector<std::string> names;
  for (const Check& check : run_checks(record, true))
    if (!check.passed()) names.push_back(check.name);
  return names;
}

}  // namespace

TEST(RunChecks, PassForATestThatMeetsThemAll)
{
  EXPECT_TRUE(failures(good_record()).empty());
}

TEST(RunChecks, FindOneSampleOfTheConfiningStressThatIsOff)
{
  ShearRecord record = good_record();
  record.confining_stress[100] = 98.5e3;
  const std::vector<Check> checks = run_checks(record, true);
  EXPECT_NEAR(checks[0].found, 0.015, 1e-12);
  EXPECT_FALSE(checks[0].passed());
  EXPECT_TRUE(checks[1].passed());
}

TEST(RunChecks, LeaveOutTheFirstSampleOfTheConfiningStress)
{
  ShearRecord record = good_record();
  record.confining_stress[0] = 90e3;
  EXPECT_TRUE(failures(record).empty());
}

// A steady 2 % too little confining stress shows in the averages as 2 %.
TEST(RunChecks, AverageTheConfiningStressOverOnePercentStrain)
{
  ShearRecord record = good_record();
  for (double& stress : record.confining_stress) stress = 98e3;
  EXPECT_NEAR(run_checks(record, true)[1].found, 0.02, 1e-12);
}

// A full wave of +-20 % per 1 % strain averages to nothing, a steady 4 % does not.
TEST(RunChecks, AverageThePlatenDifferenceOverOnePercentStrain)
{
  ShearRecord record = good_record();
  for (std::size_t i = 0; i < record.stress_top.size(); ++i)
    record.stress_top[i] *= 1.0 + 0.2 * std::sin(2.0 * pi * record.axial_strain[i] / 0.01);
  EXPECT_LT(platen_difference(record), 1e-3);
  for (std::size_t i = 1; i < record.stress_bottom.size(); ++i) record.stress_bottom[i] *= 0.96;
  EXPECT_NEAR(platen_difference(record), 0.04 / 0.98, 1e-3);
  EXPECT_EQ(failures(record).size(), 1u);
}

// 2.1 kg of grains in a cylinder that gets shorter and bulges from 50 to 57 mm: the weight is the
// same, the stress of it a quarter less. The lower platen bears both.
TEST(RunChecks, DoNotTakeTheWeightOfTheGrainsForFriction)
{
  ShearRecord record = good_record();
  for (std::size_t i = 0; i < record.stress_top.size(); ++i) {
    const double radius = 0.05 + 0.035 * record.axial_strain[i];
    const double height = 0.2 * (1.0 - record.axial_strain[i]);
    const double area = pi * radius * radius;
    record.stress_bottom[i] = record.stress_top[i] + 2.1 * 9.8 / area;
    const double porosity = 1.0 - 2.1 / 1738.0 / (area * height);
    record.weight_stress.push_back(weight_stress(1738.0, 9.8, porosity, height));
  }
  EXPECT_NEAR(platen_difference(record), 0.0, 1e-12);
  for (const double difference : platen_differences(record)) EXPECT_NEAR(difference, 0.0, 1e-12);
}

// 2.6 kPa of weight and 12 kPa of friction on the side, both there from the first row on.
TEST(RunChecks, TakeForFrictionWhatThePlatensDifferByBeforeShearBeyondTheWeight)
{
  ShearRecord record = good_record();
  for (double& stress : record.stress_bottom) stress += 2.6e3 + 12e3;
  record.weight_stress.assign(record.stress_top.size(), 2.6e3);
  EXPECT_NEAR(platen_difference(record), 12.0 / 308.6, 1e-12);
  EXPECT_EQ(failures(record).size(), 1u);
}

TEST(RunChecks, TakeNoWeightOffAndSaySoWhereItIsNotKnown)
{
  ShearRecord record = good_record();
  for (double& stress : record.stress_bottom) stress += 2.6e3;
  EXPECT_NEAR(platen_difference(record), 2.6 / 301.3, 1e-12);
  EXPECT_NE(run_checks(record, true)[2].name.find("case.json has no density"), std::string::npos);
  record.weight_stress.assign(record.stress_top.size(), 2.6e3);
  EXPECT_EQ(run_checks(record, true)[2].name.find("density"), std::string::npos);
}

TEST(RunChecks, TellThePlatenDifferenceWithoutRequiringItWhereASleeveTakesLoad)
{
  const std::vector<Check> checks = run_checks(good_record(), false);
  EXPECT_EQ(std::count_if(checks.begin(), checks.end(), [](const Check& c) { return !c.required; }),
            1);
}

TEST(RunChecks, LookAtTheUnbalancedRatioOnlyAtTheStart)
{
  ShearRecord record = good_record();
  record.unbalanced_ratio.back() = 1.0;
  EXPECT_TRUE(failures(record).empty());
  record.unbalanced_ratio.front() = 2e-5;
  EXPECT_EQ(failures(record).size(), 1u);
}

TEST(RunChecks, FindTheLargestInertialNumberAndEnergyErrorOfEitherSign)
{
  ShearRecord record = good_record();
  record.inertial_number[7] = 2e-3;
  record.energy_error[9] = -0.05;
  EXPECT_EQ(failures(record).size(), 2u);
}

TEST(RunChecks, OfPlatensThatLiftOffAreAShareOfTheConfiningStress)
{
  ShearRecord record = good_record();
  record.stress_top.assign(record.stress_top.size(), 1e-9);
  record.stress_bottom.assign(record.stress_bottom.size(), -1e-9);
  EXPECT_NEAR(platen_difference(record), 2e-9 / 100e3, 1e-20);
  record.stress_top.assign(record.stress_top.size(), 4e3);
  EXPECT_NEAR(platen_difference(record), 0.04, 1e-12);
}

TEST(RunChecks, OfATargetOfZeroFindTheStressThatIsThere)
{
  ShearRecord record = good_record();
  record.target_confining_stress = 0.0;
  EXPECT_EQ(run_checks(record, true)[0].found, 1.0);
  record.confining_stress.assign(record.confining_stress.size(), 0.0);
  EXPECT_EQ(run_checks(record, true)[0].found, 0.0);
}

TEST(RunChecks, DoNotPassWhatIsNoNumber)
{
  for (std::vector<double> ShearRecord::*column :
       {&ShearRecord::confining_stress, &ShearRecord::stress_top, &ShearRecord::inertial_number,
        &ShearRecord::energy_error}) {
    ShearRecord record = good_record();
    (record.*column)[50] = std::nan("");
    const auto checks = run_checks(record, true);
    EXPECT_TRUE(
        std::any_of(checks.begin(), checks.end(), [](const Check& c) { return c.missed(); }));
  }
}
