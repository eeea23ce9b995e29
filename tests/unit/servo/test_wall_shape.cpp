// SPDX-License-Identifier: GPL-2.0-only
#include "servo/wall_shape.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(PlaneShape, OverlapsAGrainByTheRadiusLessTheGap)
{
  const PlaneShape top{0.2, 1.0}, bottom{0.0, -1.0};
  const double high[3] = {1.0, 2.0, 0.191}, low[3] = {1.0, 2.0, 0.012};
  EXPECT_NEAR(top.overlap(high, 0.01), 0.001, 1e-15);
  EXPECT_NEAR(bottom.overlap(low, 0.01), -0.002, 1e-15);
  EXPECT_TRUE(top.touches(high, 0.01));
  EXPECT_FALSE(bottom.touches(low, 0.01));
}

TEST(PlaneShape, PointsOutOfTheSpecimenAndAdvancesIntoIt)
{
  PlaneShape top{0.2, 1.0}, bottom{0.0, -1.0};
  EXPECT_EQ(top.normal(nullptr), Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(bottom.normal(nullptr), Vec3(0.0, 0.0, -1.0));
  top.advance(0.01);
  bottom.advance(0.01);
  EXPECT_DOUBLE_EQ(top.z, 0.19);
  EXPECT_DOUBLE_EQ(bottom.z, 0.01);
}

TEST(CylinderShape, OverlapsAGrainByWhatSticksOut)
{
  const CylinderShape wall{0.05, 0.01, -0.02};
  const double near[3] = {0.01 + 0.6 * 0.045, -0.02 - 0.8 * 0.045, 7.0};
  EXPECT_NEAR(wall.overlap(near, 0.006), 0.001, 1e-15);
  EXPECT_LT(wall.overlap(near, 0.004), 0.0);
  EXPECT_TRUE(wall.touches(near, 0.006));
  EXPECT_FALSE(wall.touches(near, 0.004));
  EXPECT_NEAR((wall.normal(near) - Vec3(0.6, -0.8, 0.0)).norm(), 0.0, 1e-15);
}

TEST(CylinderShape, OverlapsAGrainLargerThanItself)
{
  const CylinderShape wall{0.005};
  const double center[3] = {0.001, 0.0, 0.0};
  EXPECT_NEAR(wall.overlap(center, 0.01), 0.006, 1e-15);
  EXPECT_TRUE(wall.touches(center, 0.01));
}

// The overlap grows as fast as the wall advances and as the grain moves out.
TEST(CylinderShape, AdvancesTowardsItsAxis)
{
  CylinderShape wall{0.05};
  const double center[3] = {0.03, 0.03, 0.0};
  const double before = wall.overlap(center, 0.01);
  wall.advance(1e-4);
  EXPECT_NEAR(wall.overlap(center, 0.01) - before, 1e-4, 1e-15);
  EXPECT_DOUBLE_EQ(wall.cross_section(), pi * 0.0499 * 0.0499);
}

TEST(CylinderShape, HasTheSurfaceAndVolumeOfAPiece)
{
  const CylinderShape wall{0.05, 0.01, -0.02};
  EXPECT_DOUBLE_EQ(wall.lateral_area(0.2), 2.0 * pi * 0.05 * 0.2);
  EXPECT_DOUBLE_EQ(wall.lateral_area(-0.2), wall.lateral_area(0.2));
  EXPECT_DOUBLE_EQ(wall.volume(0.1, 0.3), pi * 0.05 * 0.05 * 0.2);
}

TEST(CylinderShape, CountsCentersBeyondItAndBeyondBothHeights)
{
  const CylinderShape wall{0.05, 0.01, -0.02};
  const double centers[] = {0.01,  -0.02, 0.1,    // on the axis
                            0.01,  -0.02, 0.21,   // above
                            0.01,  -0.02, -0.01,  // below
                            0.055, -0.02, 0.1,    // 45 mm from the axis
                            0.01,  0.035, 0.1};   // 55 mm
  EXPECT_EQ(wall.count_outside(centers, 5, 0.0, 0.2), 3);
}
