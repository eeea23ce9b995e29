// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/sampled_curve.h"
#include "core/constants.h"
#include "core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

// Samples that crowd together at the start, as a run's do where it is sampled more often.
SampledCurve uneven(double (*y)(double))
{
  std::vector<double> xs, ys;
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.2 * std::pow(i / 400.0, 2.0);
    xs.push_back(x);
    ys.push_back(y(x));
  }
  return {xs, ys};
}

}  // namespace

TEST(SampledCurve, IsLinearBetweenItsSamplesAndConstantBeyondThem)
{
  const SampledCurve curve({0.0, 1.0, 3.0}, {0.0, 2.0, -2.0});
  EXPECT_DOUBLE_EQ(curve.value(0.25), 0.5);
  EXPECT_DOUBLE_EQ(curve.value(2.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.value(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.value(9.0), -2.0);
}

TEST(SampledCurve, OfAStraightLineHasTheMiddleValueAsMeanHoweverItWasSampled)
{
  const SampledCurve curve = uneven([](double x) { return 3.0 - 2.0 * x; });
  EXPECT_NEAR(curve.mean(0.031, 0.053), 3.0 - 2.0 * 0.042, 1e-12);
  EXPECT_NEAR(curve.mean(0.19, 0.5), 3.0 - 2.0 * 0.195, 1e-12);
}

// A centred window of width w turns sin(k x) into sin(k x) sin(k w / 2) / (k w / 2).
TEST(SampledCurve, DampsAWaveByTheSincOfTheWindow)
{
  constexpr double k = 300.0, width = 0.01;
  std::vector<double> xs, ys;
  for (int i = 0; i <= 8000; ++i) {
    xs.push_back(0.1 * i / 8000.0);
    ys.push_back(std::sin(k * xs.back()));
  }
  const std::vector<double> average = SampledCurve(xs, ys).moving_average(width);
  const double damping = std::sin(0.5 * k * width) / (0.5 * k * width);
  for (int i = 500; i <= 7500; i += 100)
    EXPECT_NEAR(average[i], damping * std::sin(k * xs[i]), 1e-5) << "at x = " << xs[i];
}

TEST(SampledCurve, AveragesNextToItsEndsOverTheSampledPartOfTheWindow)
{
  const SampledCurve curve({0.0, 1.0}, {0.0, 1.0});
  const std::vector<double> average = curve.moving_average(0.5);
  EXPECT_DOUBLE_EQ(average.front(), 0.125);
  EXPECT_DOUBLE_EQ(average.back(), 0.875);
}

TEST(SampledCurve, EndsItsLastWindowAtTheLastSample)
{
  const SampledCurve curve({0.0, 2.5}, {0.0, 2.5});
  const std::vector<double> means = curve.window_means(1.0);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_DOUBLE_EQ(means[0], 0.5);
  EXPECT_DOUBLE_EQ(means[1], 1.5);
  EXPECT_DOUBLE_EQ(means[2], 2.0);
}

TEST(SampledCurve, ShorterThanAWindowIsOneWindow)
{
  const std::vector<double> means = SampledCurve({0.0, 0.4}, {0.0, 1.0}).window_means(1.0);
  ASSERT_EQ(means.size(), 1u);
  EXPECT_DOUBLE_EQ(means[0], 0.5);
}

TEST(SampledCurve, TakesRepeatedStrainsButNoneThatFalls)
{
  EXPECT_NO_THROW(SampledCurve({0.0, 0.0, 1.0}, {0.0, 1.0, 2.0}));
  EXPECT_THROW(SampledCurve({0.0, 1.0, 0.5}, {0.0, 1.0, 2.0}), InputError);
  EXPECT_THROW(SampledCurve({0.0, 0.0}, {0.0, 1.0}), InputError);
  EXPECT_THROW(SampledCurve({0.0}, {0.0}), InputError);
}
