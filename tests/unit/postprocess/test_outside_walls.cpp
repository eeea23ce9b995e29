// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/run_checks.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(OutsideWalls, AreGrainsWhoseCenterIsBeyondAPlatenOrTheCylinder)
{
  const WallPlaces walls{{0.02, 0.20}, 0.05};
  EXPECT_FALSE(is_outside({0.0, 0.0, 0.021}, walls));
  EXPECT_FALSE(is_outside({0.0, 0.0, 0.199}, walls));
  EXPECT_FALSE(is_outside({0.03, -0.0399, 0.1}, walls));  // 49.9 mm from the axis
  EXPECT_TRUE(is_outside({0.0, 0.0, 0.019}, walls));
  EXPECT_TRUE(is_outside({0.0, 0.0, 0.201}, walls));
  EXPECT_TRUE(is_outside({0.03, -0.0401, 0.1}, walls));  // 50.1 mm
}

TEST(OutsideWalls, AreThePlatensAloneWithoutACylinder)
{
  const WallPlaces walls{{0.0, 0.2}, {}};
  EXPECT_FALSE(is_outside({9.0, 0.0, 0.1}, walls));
  EXPECT_TRUE(is_outside({0.0, 0.0, -0.001}, walls));
}

// A specimen built 200 mm high that consolidates by 2 mm and is sheared by 40 mm more.
TEST(OutsideWalls, PlaceThePlatensByTheOneThatMoves)
{
  const PlatenHeights lower = platen_heights(0.200, 0.198, 0.158, 0);
  EXPECT_NEAR(lower.bottom, 0.042, 1e-15);
  EXPECT_NEAR(lower.top, 0.200, 1e-15);
  const PlatenHeights upper = platen_heights(0.200, 0.198, 0.158, 1);
  EXPECT_NEAR(upper.bottom, 0.0, 1e-15);
  EXPECT_NEAR(upper.top, 0.158, 1e-15);
  const PlatenHeights both = platen_heights(0.200, 0.198, 0.158, 2);  // 2 + 20 mm and 20 mm
  EXPECT_NEAR(both.bottom, 0.022, 1e-15);
  EXPECT_NEAR(both.top, 0.180, 1e-15);
}
