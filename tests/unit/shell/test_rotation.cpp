// SPDX-License-Identifier: GPL-2.0-only
#include "shell/rotation.h"

#include "core/constants.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(Rotation, OfAQuarterTurnAboutZTakesXToY)
{
  const Vec3 turned_x = rotation_from_vector(Vec3(0.0, 0.0, pi / 2.0)) * Vec3::UnitX();
  EXPECT_NEAR((turned_x - Vec3::UnitY()).norm(), 0.0, 1e-15);
}

// Eigen's own angle-axis is the second derivation; 0.1 is where the series ends.
TEST(Rotation, AgreesWithTheAngleAxisOnBothSidesOfTheSeriesLimit)
{
  const Vec3 axis = Vec3(1.0, -2.0, 0.5).normalized();
  for (const double angle : {1e-9, 1e-3, 0.05, 0.0999999, 0.1000001, 0.7, 3.1}) {
    const Quaternion expected(Eigen::AngleAxisd(angle, axis));
    const Quaternion found = rotation_from_vector(angle * axis);
    EXPECT_NEAR((found.coeffs() - expected.coeffs()).norm(), 0.0, 1e-15) << "angle " << angle;
    EXPECT_NEAR(found.norm(), 1.0, 1e-15) << "angle " << angle;
  }
}

TEST(Rotation, VectorOfAQuaternionIsTheOneItWasMadeFrom)
{
  for (const double angle : {0.0, 1e-8, 0.3, 2.0, 3.14}) {
    const Vec3 v = angle * Vec3(0.6, 0.0, -0.8);
    EXPECT_NEAR((rotation_vector(rotation_from_vector(v)) - v).norm(), 0.0, 1e-14);
  }
}

TEST(Rotation, TakesTheShorterWayRound)
{
  const Vec3 v = rotation_vector(rotation_from_vector(Vec3(0.0, 0.0, 2.0 * pi - 0.1)));
  EXPECT_NEAR(v.z(), -0.1, 1e-14);
}

TEST(Rotation, OfManySmallTurnsIsTheirSumAndKeepsUnitLength)
{
  Quaternion q = Quaternion::Identity();
  for (int i = 0; i < 100000; ++i) q = turned(q, Vec3(0.0, 1.0, 0.0), 1e-5);
  EXPECT_NEAR((rotation_vector(q) - Vec3(0.0, 1.0, 0.0)).norm(), 0.0, 1e-11);
  EXPECT_NEAR(q.norm(), 1.0, 1e-15);
}
