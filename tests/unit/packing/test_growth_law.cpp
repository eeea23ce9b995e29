// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_law.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(GrowthFactor, GoesFromItsStartToExactlyOne)
{
  EXPECT_DOUBLE_EQ(growth_factor(0.5, 0.0), 0.5);
  EXPECT_EQ(growth_factor(0.5, 1.0), 1.0);
  EXPECT_EQ(growth_factor(0.7, 1.5), 1.0);
}

TEST(GrowthFactor, AddsTheSameVolumeInEachStage)
{
  const int stages = 100;
  double before = 0.5;
  for (int n = 1; n <= stages; ++n) {
    const double now = growth_factor(0.5, static_cast<double>(n) / stages);
    EXPECT_NEAR(now * now * now - before * before * before, (1.0 - 0.125) / stages, 1e-14);
    before = now;
  }
}
