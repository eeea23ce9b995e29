#include "analysis/peak_strength.h"

#include "core/input_error.h"

#include <algorithm>

namespace encased_column {

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
