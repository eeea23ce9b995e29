// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/strength.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

StressPoint stress_point(double confining_stress, double deviatoric_stress)
{
  return {confining_stress + deviatoric_stress / 3.0, deviatoric_stress};
}

FailureLine fit_failure_line(const std::vector<StressPoint>& peaks)
{
  double mean_p = 0.0, mean_q = 0.0;
  for (const StressPoint& peak : peaks) {
    mean_p += peak.mean_stress / peaks.size();
    mean_q += peak.deviatoric_stress / peaks.size();
  }
  double spread = 0.0, slope = 0.0;
  for (const StressPoint& peak : peaks) {
    spread += (peak.mean_stress - mean_p) * (peak.mean_stress - mean_p);
    slope += (peak.mean_stress - mean_p) * (peak.deviatoric_stress - mean_q);
  }
  if (!(spread > 1e-12 * mean_p * mean_p))
    throw InputError("a failure line takes peaks at two mean stresses at least, found " +
                     std::to_string(peaks.size()) +
                     " peak(s) at one, add a test at another confining stress");
  slope /= spread;
  return {slope, mean_q - slope * mean_p};
}

Strength strength_of(const FailureLine& line)
{
  if (!(line.slope >= 0.0 && line.slope < 3.0))
    throw InputError("the slope of a failure line must lie from 0 up to 3, found " +
                     in_words(line.slope) + ", check the peaks it was fitted to");
  const double sine = 3.0 * line.slope / (6.0 + line.slope);
  const double cosine = std::sqrt(1.0 - sine * sine);
  return {std::asin(sine), line.intercept * (3.0 - sine) / (6.0 * cosine)};
}

FailureLine failure_line_of(const Strength& strength)
{
  const double sine = std::sin(strength.friction_angle);
  return {6.0 * sine / (3.0 - sine),
          6.0 * strength.cohesion * std::cos(strength.friction_angle) / (3.0 - sine)};
}

PeakStrength peak_strength(const SampledCurve& deviatoric_stress)
{
  const std::vector<double>& raw = deviatoric_stress.y();
  const std::vector<double> averaged = deviatoric_stress.moving_average(peak_averaging_width);
  const auto raw_top = std::max_element(raw.begin(), raw.end());
  const auto averaged_top = std::max_element(averaged.begin(), averaged.end());
  if (!(*averaged_top > 0.0))
    throw InputError("deviatoric stress must rise above zero in shear, found at most " +
                     in_words(*averaged_top) + " Pa on average, check the platens of the run");

  PeakStrength peak;
  peak.raw = *raw_top;
  peak.averaged = *averaged_top;
  peak.noisy = peak.raw > (1.0 + peak_noise_limit) * peak.averaged;
  peak.reported = peak.noisy ? peak.averaged : peak.raw;
  const auto row = peak.noisy ? averaged_top - averaged.begin() : raw_top - raw.begin();
  peak.axial_strain = deviatoric_stress.x()[row];
  return peak;
}

std::optional<double> secant_modulus(const SampledCurve& deviatoric_stress, double peak)
{
  const std::vector<double>& q = deviatoric_stress.y();
  const std::vector<double>& strain = deviatoric_stress.x();
  const double half = 0.5 * peak;
  const auto above = std::find_if(q.begin(), q.end(), [half](double each) { return each >= half; });
  if (above == q.begin() || above == q.end()) return std::nullopt;
  const std::size_t i = above - q.begin();
  const double part = (half - q[i - 1]) / (q[i] - q[i - 1]);
  return half / (strain[i - 1] + part * (strain[i] - strain[i - 1]));
}

}  // namespace encased_column
