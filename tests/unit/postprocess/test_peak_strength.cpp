// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/strength.h"
#include "core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

constexpr double initial_modulus = 20e6;  // Pa
constexpr double asymptote = 400e3;       // Pa

// Duncan and Chang's hyperbola q = x / (1/E0 + x/q_ult), up to 20 % strain.
SampledCurve hyperbola(double noise = 0.0)
{
  std::vector<double> strain, q;
  for (int i = 0; i <= 2000; ++i) {
    const double x = 1e-4 * i;
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    strain.push_back(x);
    q.push_back(x / (1.0 / initial_modulus + x / asymptote) * (1.0 + sign * noise));
  }
  return {strain, q};
}

}  // namespace

// On the hyperbola q / x = E0 (1 - q / q_ult), so that E50 = E0 (1 - peak / (2 q_ult)).
TEST(SecantModulus, OfAHyperbolaIsItsInitialModulusLessTheShareOfHalfThePeak)
{
  const SampledCurve curve = hyperbola();
  const PeakStrength peak = peak_strength(curve);
  const double exact_peak = 0.2 / (1.0 / initial_modulus + 0.2 / asymptote);
  EXPECT_DOUBLE_EQ(peak.reported, exact_peak);
  // Linear interpolation over 1e-4 of strain errs by h^2 q''/8, which is 1e-5 of q at half peak.
  const double exact = initial_modulus * (1.0 - 0.5 * exact_peak / asymptote);
  EXPECT_NEAR(secant_modulus(curve, peak.reported).value() / exact, 1.0, 2e-5);
}

TEST(SecantModulus, TakesTheFirstTimeTheCurvePassesHalfThePeak)
{
  const SampledCurve curve({0.0, 0.01, 0.02, 0.03, 0.04}, {0.0, 60e3, 40e3, 100e3, 20e3});
  EXPECT_DOUBLE_EQ(secant_modulus(curve, 100e3).value(), 50e3 / (0.01 * 5.0 / 6.0));
}

TEST(SecantModulus, IsNoneOfACurveThatStartsAboveHalfItsPeakOrEndsBelow)
{
  EXPECT_FALSE(secant_modulus(SampledCurve({0.0, 0.1}, {60e3, 100e3}), 100e3));
  EXPECT_FALSE(secant_modulus(SampledCurve({0.0, 0.1}, {0.0, 40e3}), 100e3));
}

TEST(PeakStrength, OfASmoothCurveIsItsLargestSample)
{
  const SampledCurve curve({0.0, 0.04, 0.05, 0.06, 0.2}, {0.0, 99e3, 100e3, 99e3, 80e3});
  const PeakStrength peak = peak_strength(curve);
  EXPECT_FALSE(peak.noisy);
  EXPECT_DOUBLE_EQ(peak.reported, 100e3);
  EXPECT_DOUBLE_EQ(peak.axial_strain, 0.05);
}

// Alternate samples 3 % up and down average out: what is left is the hyperbola averaged over the
// last half window, between its values there.
TEST(PeakStrength, OfANoisyCurveIsItsAverageOverHalfAPercentStrain)
{
  const PeakStrength peak = peak_strength(hyperbola(0.03));
  const double exact_peak = 0.2 / (1.0 / initial_modulus + 0.2 / asymptote);
  EXPECT_TRUE(peak.noisy);
  EXPECT_DOUBLE_EQ(peak.raw, 1.03 * exact_peak);
  EXPECT_NEAR(peak.reported / exact_peak, 1.0, 2e-3);
}

TEST(PeakStrength, NeedsADeviatoricStressAboveZero)
{
  EXPECT_THROW(peak_strength(SampledCurve({0.0, 0.1}, {-1.0, -2.0})), InputError);
}
