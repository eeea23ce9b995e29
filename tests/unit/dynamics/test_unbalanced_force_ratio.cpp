// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/unbalanced_force_ratio.h"

#include <gtest/gtest.h>

using namespace encased_column;

// Forces of 3 N, 4 N and 5 N on three grains that move, 100 N on one that does not.
TEST(UnbalancedForceRatio, IsTheMeanOfTheMovingGrainsOverTheMeanContactForce)
{
  const double force[12] = {3, 0, 0, 0, -4, 0, 0, 3, 4, 100, 0, 0};
  const int mask[4] = {1, 3, 1, 2};
  const double mass[4] = {1, 1, 1, 1};
  GrainLoads loads;
  loads.clear(4);
  loads.add(0, 1, 30.0, 1.0);
  loads.add(1, 2, 10.0, 0.5);
  loads.add(2, -1, 10.0, 0.5);
  ForceSums sums = loads.sums();
  const double largest = sums.add_grains({force, loads.load(4), mass, 9.8, mask, 1, 4});
  EXPECT_EQ(largest, 5.0);
  const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
  EXPECT_EQ(ratio.average, 4.0 / 20.0);
  EXPECT_EQ(ratio.maximum, 5.0 / 20.0);
  EXPECT_EQ(ratio.contacts, 2.0);
}

TEST(UnbalancedForceRatio, OfGrainsThatFlyIsOne)
{
  const double force[6] = {1, 0, 0, 3, 0, 0};
  const int mask[2] = {1, 1};
  const double mass[2] = {1, 1};
  for (const double contact : {0.0, 1e-300, 1e-25, 1.0}) {
    GrainLoads loads;
    loads.clear(2);
    loads.add(0, -1, contact, 1.0);
    ForceSums sums = loads.sums();
    const double largest = sums.add_grains({force, loads.load(2), mass, 0.0, mask, 1, 2});
    const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
    EXPECT_EQ(ratio.average, 1.0) << "contact force " << contact;
    EXPECT_LE(ratio.maximum, 1.5);
  }
}

// Five grains of 0.1 kg under 10 m/s^2, of 1 N weight: two press on each other by 100 N and are out
// of balance by 0.5 N each, one lies on the first with 3 N, one falls, one is held. What the
// falling grain and the lying one leave over, 1 N and 2 N, counts in the average alone.
TEST(UnbalancedForceRatio, OfBearingGrainsLeavesOutWhatFallsOrLiesOnTheOthers)
{
  const double force[15] = {0.5, 0, 0, -0.5, 0, 0, 0, 0, -2, 0, 0, -1, 7, 0, 0};
  const int mask[5] = {1, 1, 1, 1, 2};
  const double mass[5] = {0.1, 0.1, 0.1, 0.1, 0.1};
  GrainLoads loads;
  loads.clear(5);
  loads.add(0, 1, 100.0, 1.0);
  loads.add(2, 0, 3.0, 1.0);
  ForceSums sums = loads.sums();
  const double largest = sums.add_grains({force, loads.load(5), mass, 10.0, mask, 1, 5});
  const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
  EXPECT_DOUBLE_EQ(ratio.average, (4.0 / 4.0) / (103.0 / 2.0));
  EXPECT_DOUBLE_EQ(ratio.bearing, (1.0 / 4.0) / (103.0 / 2.0));
}

TEST(UnbalancedForceRatio, OfBearingGrainsIsTheAverageWithoutWeight)
{
  const double force[9] = {0.5, 0, 0, -0.25, 0, 0, 0, 0, 0};
  const int mask[3] = {1, 1, 1};
  const double mass[3] = {0.1, 0.1, 0.1};
  GrainLoads loads;
  loads.clear(2);
  loads.add(0, 1, 1e-3, 1.0);
  ForceSums sums = loads.sums();
  const double largest = sums.add_grains({force, loads.load(3), mass, 0.0, mask, 1, 3});
  const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
  EXPECT_DOUBLE_EQ(ratio.bearing, ratio.average);
}
