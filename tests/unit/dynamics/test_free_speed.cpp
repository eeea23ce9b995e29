// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/inertia.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(FeelsOnlyWeight, IsTrueToTenDigits)
{
  const Vec3 gravity(0.0, 0.0, -9.8);
  const double mass = 1e-3;
  EXPECT_TRUE(feels_only_weight(Vec3(0.0, 0.0, -9.8e-3), mass, gravity));
  EXPECT_TRUE(feels_only_weight(Vec3(9e-13, 0.0, -9.8e-3), mass, gravity));
  EXPECT_FALSE(feels_only_weight(Vec3(1.1e-12, 0.0, -9.8e-3), mass, gravity));
  EXPECT_FALSE(feels_only_weight(Vec3::Zero(), mass, gravity)) << "held by its contacts";
}

TEST(FeelsOnlyWeight, IsNoForceAtAllWithoutGravity)
{
  EXPECT_TRUE(feels_only_weight(Vec3::Zero(), 1e-3, Vec3::Zero()));
  EXPECT_FALSE(feels_only_weight(Vec3(1e-30, 0.0, 0.0), 1e-3, Vec3::Zero()));
}

// From 5 m/s to 2 m/s, m (25 - 4) / 2 is lost and the direction kept.
TEST(SlowDownTo, KeepsTheDirectionAndReturnsTheEnergyLost)
{
  double velocity[3] = {3.0, 0.0, -4.0};
  EXPECT_DOUBLE_EQ(slow_down_to(4.0, 2.0, velocity), 21.0);
  EXPECT_DOUBLE_EQ(velocity[0], 1.2);
  EXPECT_EQ(velocity[1], 0.0);
  EXPECT_DOUBLE_EQ(velocity[2], -1.6);
}
