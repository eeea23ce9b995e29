#include "dynamics/unbalanced_force_ratio.h"

#include <gtest/gtest.h>

using namespace encased_column;

// Forces of 3 N, 4 N and 5 N on three grains that move, 100 N on one that does not.
TEST(UnbalancedForceRatio, IsTheMeanOfTheMovingGrainsOverTheMeanContactForce)
{
  const double force[12] = {3, 0, 0, 0, -4, 0, 0, 3, 4, 100, 0, 0};
  const int mask[4] = {1, 3, 1, 2};
  ForceSums sums;
  const double largest = sums.add_grains(force, mask, 1, 4);
  EXPECT_EQ(largest, 5.0);
  sums.add_contact(30.0, 1.0);
  sums.add_contact(10.0, 0.5);
  sums.add_contact(10.0, 0.5);
  const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
  EXPECT_EQ(ratio.average, 4.0 / 20.0);
  EXPECT_EQ(ratio.maximum, 5.0 / 20.0);
  EXPECT_EQ(ratio.contacts, 2.0);
}

TEST(UnbalancedForceRatio, OfGrainsThatFlyIsOne)
{
  const double force[6] = {1, 0, 0, 3, 0, 0};
  const int mask[2] = {1, 1};
  for (const double contact : {0.0, 1e-300, 1e-25, 1.0}) {
    ForceSums sums;
    const double largest = sums.add_grains(force, mask, 1, 2);
    sums.add_contact(contact, 1.0);
    const UnbalancedForceRatio ratio = compute_unbalanced_ratio(sums, largest);
    EXPECT_EQ(ratio.average, 1.0) << "contact force " << contact;
    EXPECT_LE(ratio.maximum, 1.5);
  }
}
