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
