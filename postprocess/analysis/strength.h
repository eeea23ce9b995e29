// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/sampled_curve.h"

#include <optional>
#include <vector>

namespace encased_column {

/// A state of triaxial stress: p = (sigma1 + 2 sigma3) / 3 and q = sigma1 - sigma3, both [Pa].
/// The study plots a "p-q line" without saying which p it means; through exact Mohr-Coulomb
/// states every convention gives the same friction angle and cohesion.
struct StressPoint {
  double mean_stress;        ///< p [Pa]
  double deviatoric_stress;  ///< q [Pa]
};

/// The state with lateral stress `confining_stress` [Pa] and q = `deviatoric_stress` [Pa].
StressPoint stress_point(double confining_stress, double deviatoric_stress);

/// A failure line q = slope p + intercept.
struct FailureLine {
  double slope;      ///< M [-]
  double intercept;  ///< q at p = 0 [Pa]

  double deviatoric_stress(double mean_stress) const { return slope * mean_stress + intercept; }
};

/// The same line in the words of Mohr and Coulomb.
struct Strength {
  double friction_angle;  ///< apparent, phi [rad]
  double cohesion;        ///< apparent, c [Pa]
};

/// Least-squares line through peak states. Throws InputError with fewer than two different p.
FailureLine fit_failure_line(const std::vector<StressPoint>& peaks);

/// sin(phi) = 3 M / (6 + M) and c = intercept (3 - sin(phi)) / (6 cos(phi)), from
/// sigma1 = Kp sigma3 + 2 c sqrt(Kp), Kp = (1 + sin(phi)) / (1 - sin(phi)), written in p and q.
/// Throws InputError unless the slope is that of a friction angle from 0 up to 90 degrees.
Strength strength_of(const FailureLine& line);

/// The inverse: M = 6 sin(phi) / (3 - sin(phi)), intercept 6 c cos(phi) / (3 - sin(phi)).
FailureLine failure_line_of(const Strength& strength);

/// Width [-] of axial strain over which a noisy curve is averaged for its peak.
constexpr double peak_averaging_width = 0.005;

/// Largest share [-] by which the raw maximum may exceed the averaged one before it is taken as
/// noise of single samples and the averaged one is reported.
constexpr double peak_noise_limit = 0.01;

/// The peak of a test's deviatoric stress, both ways of reading it.
struct PeakStrength {
  double raw;           ///< largest sample [Pa]
  double averaged;      ///< largest moving average over `peak_averaging_width` [Pa]
  double reported;      ///< one of the two, see `noisy` [Pa]
  double axial_strain;  ///< of the reported peak [-]
  bool noisy;           ///< raw exceeds averaged by more than `peak_noise_limit`
};

/// Reads the peak of `deviatoric_stress` [Pa] over axial strain [-]: the raw maximum, unless
/// noise lifts it above the moving average by more than the limit. A test cut off while it still
/// rises by more than 8 % per 1 % strain looks noisy too: its last average lags behind. Throws
/// InputError if the deviatoric stress never rises above zero.
PeakStrength peak_strength(const SampledCurve& deviatoric_stress);

/// Secant modulus E50 [Pa]: half of `peak` [Pa] over the axial strain at which the curve first
/// reaches it, linear between samples. Nothing if the first sample is above that half already or
/// none reaches it.
std::optional<double> secant_modulus(const SampledCurve& deviatoric_stress, double peak);

}  // namespace encased_column
