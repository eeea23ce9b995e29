// SPDX-License-Identifier: GPL-2.0-only
#include "runs/run_result.h"

#include "analysis/strength.h"

#include <limits>

namespace encased_column {

RunResult result_of_curve(const std::vector<double>& strain, const std::vector<double>& stress,
                          double confining_stress)
{
  constexpr double last_stretch = 0.01;  // of axial strain
  RunResult result;
  result.strain = strain;
  result.stress = stress;
  const SampledCurve curve(strain, stress);
  const PeakStrength peak = peak_strength(curve);
  const double end = curve.x().back();
  result.values["peak_q"] = peak.reported;
  result.values["peak_strain"] = peak.axial_strain;
  result.values["peak_p"] = stress_point(confining_stress, peak.reported).mean_stress;
  result.values["end_q"] = curve.mean(end - last_stretch, end);
  result.values["end_ratio"] = result.values["end_q"] / peak.reported;
  if (const auto modulus = secant_modulus(curve, peak.reported))
    result.values["secant_modulus"] = *modulus;
  return result;
}

void thin_curve(RunResult& result, int samples)
{
  if (result.strain.size() <= static_cast<std::size_t>(samples)) return;
  const SampledCurve curve(result.strain, result.stress);
  result.strain.clear();
  result.stress.clear();
  const double first = curve.x().front(), span = curve.x().back() - first;
  for (int n = 0; n < samples; ++n) {
    result.strain.push_back(first + span * n / (samples - 1));
    result.stress.push_back(curve.value(result.strain.back()));
  }
}

}  // namespace encased_column
