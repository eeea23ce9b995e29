// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/round_steps.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen)
{
  EXPECT_DOUBLE_EQ(round_step(450.0, 10), 50.0);
  EXPECT_DOUBLE_EQ(round_step(20.0, 10), 2.0);
  EXPECT_DOUBLE_EQ(round_step(10.0, 10), 1.0);
  EXPECT_DOUBLE_EQ(round_step(10.1, 10), 2.0);
  EXPECT_DOUBLE_EQ(round_step(0.0041, 5), 0.001);
}

// 22 in steps of 2 is more than ten parts: the steps grow to 5, and the range with them.
TEST(RoundRange, GrowsItsStepWhereRoundingAddsAPartTooMany)
{
  const RoundRange range = round_range(-0.1, 19.5, 10);
  EXPECT_DOUBLE_EQ(range.low, -5.0);
  EXPECT_DOUBLE_EQ(range.high, 20.0);
}

TEST(RoundRange, HoldsTheValuesInWholeStepsOfItsOwnSpan)
{
  for (double high = 1e-3; high < 1e4; high *= 1.23)
    for (const double low : {0.0, -0.013 * high, -0.7 * high}) {
      const RoundRange range = round_range(low, high, 10);
      const double step = round_step(range.high - range.low, 10);
      EXPECT_LE(range.low, low + 1e-8 * step);
      EXPECT_GE(range.high, high - 1e-8 * step);
      EXPECT_NEAR(std::remainder(range.low, step), 0.0, 1e-8 * step) << low << ' ' << high;
      EXPECT_NEAR(std::remainder(range.high, step), 0.0, 1e-8 * step) << low << ' ' << high;
    }
}

// Whatever the span: enough, as the step fits it in the parts allowed, and no more than needed, as
// the next finer round step does not.
TEST(RoundStep, IsTheSmallestThatKeepsToThePartsAllowed)
{
  for (double span = 1e-6; span < 1e6; span *= 1.37) {
    const double step = round_step(span, 7);
    EXPECT_LE(span / step, 7.0 * (1.0 + 1e-8)) << span;
    const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    const double finer = mantissa > 4.9 && mantissa < 5.1 ? step * 0.4 : step * 0.5;
    EXPECT_GT(span / finer, 7.0 * (1.0 - 1e-8)) << span;
  }
}
