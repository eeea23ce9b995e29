// SPDX-License-Identifier: GPL-2.0-only
#include "measure/contact_force.h"

#include <gtest/gtest.h>

using namespace encased_column;

// 3-4-5: the normal bears 4 N in pressure, the surface 3 N.
TEST(ContactForce, IsSplitIntoPressureAndShear)
{
  const Vec3 normal(0.0, 0.6, 0.8), along(0.0, -0.8, 0.6);
  const Vec3 force = -4.0 * normal + 3.0 * along;
  EXPECT_DOUBLE_EQ(normal_force(force, normal), 4.0);
  EXPECT_DOUBLE_EQ(shear_force(force, normal), 3.0);
}

TEST(ContactForces, AreCountedByKindAndLevel)
{
  ContactForces forces({5.0, 20.0});
  forces.add(0, 4.0, true);
  forces.add(0, 5.0, false);
  forces.add(2, 32.0, false);
  forces.add(1, 19.0, false);
  EXPECT_EQ(forces.contacts(), 4.0);
  EXPECT_EQ(forces.of_kind(0), 2.0);
  EXPECT_EQ(forces.of_kind(1), 1.0);
  EXPECT_EQ(forces.of_kind(2), 1.0);
  EXPECT_EQ(forces.above(0), 3.0) << "a contact that bears the level counts";
  EXPECT_EQ(forces.share_above(0), 0.75);
  EXPECT_EQ(forces.share_above(1), 0.25);
  EXPECT_EQ(forces.mean(), 15.0);
  EXPECT_EQ(forces.largest(), 32.0);
  EXPECT_EQ(forces.sliding_fraction(), 0.25);
}

TEST(ContactForces, OfTwoRanksAddUpToThoseOfOne)
{
  ContactForces one({5.0}), here({5.0}), there({5.0});
  for (const double force : {1.0, 6.0, 7.0}) {
    one.add(0, force, force > 6.0);
    (force > 6.0 ? there : here).add(0, force, force > 6.0);
  }
  for (std::size_t n = 0; n < here.sums().size(); ++n) here.sums()[n] += there.sums()[n];
  EXPECT_EQ(here.sums(), one.sums());
}

TEST(ContactForces, StartAnewWithTheSameLevels)
{
  ContactForces forces({5.0});
  forces.add(1, 8.0, true);
  forces.clear();
  EXPECT_EQ(forces.contacts() + forces.above(0) + forces.largest(), 0.0);
  EXPECT_EQ(forces.mean() + forces.share_above(0) + forces.sliding_fraction(), 0.0);
  EXPECT_EQ(forces.levels(), std::vector<double>{5.0});
}
