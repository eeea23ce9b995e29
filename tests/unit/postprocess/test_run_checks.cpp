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
  for (int i = 0; i <= 400; ++i) {
    record.axial_strain.push_back(0.0005 * i);
    record.confining_stress.push_back(100e3);
    record.stress_top.push_back(300e3);
    record.stress_bottom.push_back(300e3);
    record.unbalanced_average.push_back(9e-6);
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

// 200 mm of grains weigh some 2 kPa, 4 % of a confining stress of 50 kPa.
TEST(RunChecks, DoNotTakeTheWeightOfTheGrainsForFriction)
{
  ShearRecord record = good_record();
  for (double& stress : record.stress_bottom) stress += 12e3;
  EXPECT_NEAR(platen_difference(record), 0.0, 1e-12);
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
  record.unbalanced_average.back() = 1.0;
  EXPECT_TRUE(failures(record).empty());
  record.unbalanced_average.front() = 2e-5;
  EXPECT_EQ(failures(record).size(), 1u);
}

TEST(RunChecks, FindTheLargestInertialNumberAndEnergyErrorOfEitherSign)
{
  ShearRecord record = good_record();
  record.inertial_number[7] = 2e-3;
  record.energy_error[9] = -0.05;
  EXPECT_EQ(failures(record).size(), 2u);
}
