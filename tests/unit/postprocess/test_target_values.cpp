// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/relative_density.h"
#include "analysis/target_values.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// 100 mm x 500 mm, upper platen down; pressure rises by 10 kPa a millimetre. At the end the sleeve
/// is widest 100 mm below the platen that came down by 30 mm.
TargetRecord column()
{
  TargetRecord test{};
  test.shape = {0.1, 0.5, 0.5, 1};
  for (int i = 0; i <= 30; ++i) {
    test.displacement.push_back(1e-3 * i);
    test.pressure.push_back(50e3 + 10e3 * i);
  }
  test.profiles = {{0.0, {0.0, 0.25, 0.5}, {0.0, 0.0, 0.0}},
                   {0.06, {0.0, 0.17, 0.27, 0.37, 0.47}, {0.0, 0.0, 1e-3, 3e-3, 0.0}}};
  return test;
}

}  // namespace

// Table 6 of the study: 0.417 at 40 %, 0.397 at 90 %; between 40 and 50 % straight in n / (1 - n).
TEST(RelativeDensity, IsStraightInTheVoidRatio)
{
  const std::vector<DensityPoint> table{{0.4, 0.417}, {0.5, 0.413}, {0.9, 0.397}};
  EXPECT_NEAR(relative_density_at(0.417, table).value(), 0.4, 1e-12);
  EXPECT_NEAR(porosity_at(0.9, table).value(), 0.397, 1e-12);
  const double middle = 0.5 * (0.417 / 0.583 + 0.413 / 0.587);  // void ratio
  EXPECT_NEAR(porosity_at(0.45, table).value(), middle / (1.0 + middle), 1e-12);
  EXPECT_FALSE(relative_density_at(0.3, table));
}

TEST(TargetCondition, IsReadFromItsWords)
{
  const TargetCondition found = target_condition("S1 L/D=5 sigma3=50 kPa Dr=80 %");
  EXPECT_DOUBLE_EQ(found.confining_stress.value(), 50e3);
  EXPECT_DOUBLE_EQ(found.relative_density.value(), 0.8);
  EXPECT_DOUBLE_EQ(found.slenderness.value(), 5.0);
  EXPECT_EQ(found.gradation, "S1");
  EXPECT_DOUBLE_EQ(target_condition("S2 at 24 mm").displacement.value(), 24e-3);
  EXPECT_DOUBLE_EQ(target_condition("8 % elongation").elongation.value(), 0.08);
  EXPECT_FALSE(target_condition("sigma3=50 kPa").relative_density);
  const TargetCondition between = target_condition("range 4 to 5; S1 L/D=5 sigma3=50 kPa");
  EXPECT_EQ(between.range.value(), std::pair(4.0, 5.0));
  EXPECT_DOUBLE_EQ(between.slenderness.value(), 5.0);
  EXPECT_FALSE(found.range);
}

TEST(TargetValues, OfAColumnAreReadWhereTheStudyReadsThem)
{
  const TargetRecord test = column();
  TargetCondition at;
  at.displacement = 24e-3;
  EXPECT_NEAR(pressure_at(test, at).value(), 290e3, 1.0);
  at.displacement = 40e-3;
  EXPECT_FALSE(pressure_at(test, at)) << "it did not go so far";
  EXPECT_NEAR(pressure_at_the_end(test, {}).value(), 345e3, 5.1e3);
  EXPECT_NEAR(depth_of_peak_expansion(test, {}).value(), 1.0, 1e-9);
  // Half of 3 mm lies a quarter of the way from 1 to 3 mm, 75 mm below the widest ring.
  EXPECT_NEAR(depth_of_expansion(test, {}).value(), 1.75, 1e-9);
  at.displacement = 30e-3;
  EXPECT_NEAR(largest_expansion(test, at).value(), 3e-3, 1e-12);
}

TEST(TargetValues, AreNotThereWhereTheTestDidNotWriteThem)
{
  const TargetRecord nothing{};
  TargetCondition at;
  at.displacement = 1e-3;
  at.elongation = 0.02;
  for (const TargetValue& kind : target_values())
    EXPECT_FALSE(kind.value(nothing, at)) << kind.quantity;
}

TEST(TargetValues, OfAStripEndWithItsTable)
{
  TargetRecord test{};
  test.strip_strain = {0.0, 0.02, 0.08};
  test.strip_tension = {0.0, 2300.0, 9200.0};
  TargetCondition at;
  at.elongation = 0.05;
  EXPECT_NEAR(strip_tension(test, at).value(), 5750.0, 1e-9);
  at.elongation = 0.1;
  EXPECT_FALSE(strip_tension(test, at));
}
