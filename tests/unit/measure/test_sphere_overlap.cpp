// SPDX-License-Identifier: GPL-2.0-only
#include "measure/sphere_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

TEST(SphereOverlap, IsZeroWhenTheSpheresDoNotTouch)
{
  EXPECT_EQ(sphere_overlap_volume(2.0, 1.0, 3.5), 0.0);
}

TEST(SphereOverlap, IsTheSmallerSphereWhenItLiesInside)
{
  EXPECT_DOUBLE_EQ(sphere_overlap_volume(2.0, 0.5, 0.0), sphere_volume(0.5));
  EXPECT_DOUBLE_EQ(sphere_overlap_volume(0.5, 2.0, 1.0), sphere_volume(0.5));
}

TEST(SphereOverlap, IsContinuousWhereTheSmallerSphereStartsToStickOut)
{
  EXPECT_NEAR(sphere_overlap_volume(2.0, 0.5, 1.5 + 1e-9), sphere_volume(0.5), 1e-8);
}

TEST(SphereOverlap, IsContinuousWhereTheSpheresMeet)
{
  EXPECT_NEAR(sphere_overlap_volume(2.0, 0.5, 2.5 - 1e-9), 0.0, 1e-16);
}

TEST(SphereOverlap, OfUnitSpheresOneRadiusApartIsFivePiOverTwelve)
{
  EXPECT_DOUBLE_EQ(sphere_overlap_volume(1.0, 1.0, 1.0), 5.0 * pi / 12.0);
}

// Independent of the formula under test: pulling the spheres apart by dd loses the disc
// they share, so dV/dd = -pi c^2, with c the radius of the circle where they meet.
TEST(SphereOverlap, ShrinksByTheSharedDiscAsTheSpheresPart)
{
  const double a = 2.0, b = 1.5, step = 1e-5;
  for (double d = 0.6; d < 3.4; d += 0.2) {
    const double x = (d * d + a * a - b * b) / (2.0 * d);
    const double slope =
        (sphere_overlap_volume(a, b, d + step) - sphere_overlap_volume(a, b, d - step)) /
        (2.0 * step);
    EXPECT_NEAR(slope, -pi * (a * a - x * x), 1e-7) << "at d = " << d;
  }
}

TEST(SphereCap, IsNothingHalfOrAllOfTheSphere)
{
  EXPECT_EQ(sphere_cap_volume(2.0, 2.5), 0.0);
  EXPECT_DOUBLE_EQ(sphere_cap_volume(2.0, 0.0), 0.5 * sphere_volume(2.0));
  EXPECT_DOUBLE_EQ(sphere_cap_volume(2.0, -2.5), sphere_volume(2.0));
}

TEST(SphereCap, IsTheLimitOfTheOverlapWithAVeryLargeSphere)
{
  const double large = 1e6;
  for (const double d : {0.2, 0.9, 1.7})
    EXPECT_NEAR(sphere_cap_volume(2.0, d), sphere_overlap_volume(large, 2.0, large + d), 2e-4)
        << "at d = " << d;
}

TEST(SphereCap, ShrinksByItsDiscAsThePlaneMovesOut)
{
  const double r = 2.0, step = 1e-5;
  for (double d = -1.8; d < 1.9; d += 0.3) {
    const double slope =
        (sphere_cap_volume(r, d + step) - sphere_cap_volume(r, d - step)) / (2.0 * step);
    EXPECT_NEAR(slope, -pi * (r * r - d * d), 1e-7) << "at d = " << d;
  }
}
