// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/strength.h"
#include "core/constants.h"
#include "core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

constexpr double one_degree = pi / 180.0;

// The Mohr circle that touches tau = c + sigma tan(phi): its radius is c cos(phi) + centre
// sin(phi), the centre sigma3 + radius.
StressPoint touching_circle(double sigma3, double phi, double c)
{
  const double radius = (c * std::cos(phi) + sigma3 * std::sin(phi)) / (1.0 - std::sin(phi));
  return stress_point(sigma3, 2.0 * radius);
}

}  // namespace

TEST(StressPoint, HasAThirdOfTheDeviatorAboveTheConfiningStressAsMean)
{
  const double sigma1 = 400e3, sigma3 = 100e3;
  EXPECT_DOUBLE_EQ(stress_point(sigma3, sigma1 - sigma3).mean_stress,
                   (sigma1 + 2.0 * sigma3) / 3.0);
}

TEST(FailureLine, ThroughThreeExactMohrCirclesGivesBackFrictionAngleAndCohesion)
{
  for (const double phi : {5.0 * one_degree, 36.4 * one_degree, 60.0 * one_degree})
    for (const double c : {0.0, 2.1e3, 153.8e3}) {
      std::vector<StressPoint> peaks;
      for (const double sigma3 : {50e3, 100e3, 150e3})
        peaks.push_back(touching_circle(sigma3, phi, c));
      const Strength strength = strength_of(fit_failure_line(peaks));
      EXPECT_NEAR(strength.friction_angle, phi, 1e-10);
      EXPECT_NEAR(strength.cohesion, c, 1e-5);
    }
}

// Published: 36.5 deg and 0.5 kPa, from which 148.8, 295.6 and 442.4 kPa were derived.
TEST(FailureLine, OfThePublishedStrengthPassesThroughThePublishedPeaks)
{
  const FailureLine line = failure_line_of({36.5 * one_degree, 0.5e3});
  const double sigma3[] = {50e3, 100e3, 150e3}, q[] = {148.8e3, 295.6e3, 442.4e3};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(line.deviatoric_stress(sigma3[i] + q[i] / 3.0), q[i], 0.1e3);
}

TEST(FailureLine, MinimisesTheSquaredDistances)
{
  const std::vector<StressPoint> peaks{{1.0, 1.0}, {2.0, 3.0}, {4.0, 3.0}};
  const FailureLine best = fit_failure_line(peaks);
  const auto squares = [&peaks](const FailureLine& line) {
    double sum = 0.0;
    for (const StressPoint& peak : peaks)
      sum += std::pow(line.deviatoric_stress(peak.mean_stress) - peak.deviatoric_stress, 2.0);
    return sum;
  };
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(squares({best.slope + step, best.intercept}), squares(best));
    EXPECT_GT(squares({best.slope, best.intercept + step}), squares(best));
  }
}

TEST(FailureLine, NeedsPeaksAtTwoMeanStresses)
{
  EXPECT_THROW(fit_failure_line({}), InputError);
  EXPECT_THROW(fit_failure_line({{1e5, 2e5}}), InputError);
  EXPECT_THROW(fit_failure_line({{1e5, 2e5}, {1e5, 3e5}}), InputError);
}

TEST(Strength, IsRefusedForASlopeNoFrictionAngleHas)
{
  EXPECT_THROW(strength_of({3.0, 0.0}), InputError);
  EXPECT_THROW(strength_of({-0.1, 0.0}), InputError);
}
