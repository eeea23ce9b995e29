#pragma once

#include "analysis/sampled_curve.h"

#include <optional>

namespace encased_column {

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
