// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/run_checks.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

/// The larger of two; what is no number is larger than all, so that it passes no check.
double worse(double a, double b)
{
  return b <= a || std::isnan(a) ? a : b;
}

double largest_magnitude(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values) largest = worse(largest, std::abs(value));
  return largest;
}

/// Relative to the target; to the largest stress there was where the target is zero.
double largest_departure(const std::vector<double>& values, double target, std::size_t first)
{
  double largest = 0.0;
  for (std::size_t i = first; i < values.size(); ++i) {
    const double departure = target != 0.0      ? std::abs(values[i] / target - 1.0)
                             : values[i] == 0.0 ? 0.0
                                                : std::abs(values[i]) / largest_magnitude(values);
    largest = worse(largest, departure);
  }
  return largest;
}

/// Relative to the mean of both, or to the confining stress where that is larger: platens that lift
/// off do not differ by a share of nothing.
double relative_difference(double top, double bottom, double confining_stress)
{
  const double size = std::max(0.5 * (std::abs(top) + std::abs(bottom)), confining_stress);
  return size == 0.0 ? 0.0 : (top - bottom) / size;
}

/// What the lower platen carries [Pa] if nothing but the platens bears the grains.
std::vector<double> top_with_weight(const ShearRecord& record)
{
  std::vector<double> stress = record.stress_top;
  for (std::size_t i = 0; i < record.weight_stress.size(); ++i)
    stress[i] += record.weight_stress[i];
  return stress;
}

}  // namespace

double platen_difference(const ShearRecord& record)
{
  const std::vector<double> top = SampledCurve(record.axial_strain, top_with_weight(record))
                                      .window_means(check_averaging_width);
  const std::vector<double> bottom =
      SampledCurve(record.axial_strain, record.stress_bottom).window_means(check_averaging_width);
  double largest = 0.0;
  for (std::size_t i = 0; i < top.size(); ++i)
    largest = worse(
        largest, std::abs(relative_difference(top[i], bottom[i], record.target_confining_stress)));
  return largest;
}

std::vector<double> platen_differences(const ShearRecord& record)
{
  const std::vector<double> top = top_with_weight(record);
  std::vector<double> differences;
  for (std::size_t i = 0; i < top.size(); ++i)
    differences.push_back(
        relative_difference(top[i], record.stress_bottom[i], record.target_confining_stress));
  return differences;
}

std::vector<Check> run_checks(const ShearRecord& record, bool platens_must_agree)
{
  const double sigma3 = record.target_confining_stress;
  const std::vector<double> confining_means =
      SampledCurve(record.axial_strain, record.confining_stress)
          .window_means(check_averaging_width);
  return {
      // The first row is the state the shear stage finds, not one it made.
      {"confining stress held, every sample", largest_departure(record.confining_stress, sigma3, 1),
       0.01, true},
      {"confining stress held, averages over 1 % strain",
       largest_departure(confining_means, sigma3, 0), 0.01, true},
      {record.weight_stress.empty()
           ? "top and bottom platen stress equal, averages over 1 % strain (weight of the grains "
             "not taken off: case.json has no density)"
           : "top and bottom platen stress equal but for the weight, averages over 1 % strain",
       platen_difference(record), 0.03, platens_must_agree},
      {"unbalanced force ratio (" + record.unbalanced_kind + ") at the start of shear",
       record.unbalanced_ratio.front(), 1e-5, true},
      {"inertial number, largest", largest_magnitude(record.inertial_number), 1e-3, true},
      {"energy balance error, largest", largest_magnitude(record.energy_error), 0.02, true},
  };
}

}  // namespace encased_column
