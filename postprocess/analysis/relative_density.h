// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <optional>
#include <vector>

namespace encased_column {

/// A relative density [-] and the porosity [-] of the laboratory's sample that has it.
struct DensityPoint {
  double relative_density, porosity;
};

/// Relative density [-] of a sample of `porosity` [-]: straight in the void ratio e = n / (1 - n)
/// between the neighbours among `points`, as relative density is defined by void ratios. Nothing
/// beyond the points, but for what a porosity of three digits hides.
std::optional<double> relative_density_at(double porosity, std::vector<DensityPoint> points);

/// The inverse.
std::optional<double> porosity_at(double relative_density, std::vector<DensityPoint> points);

}  // namespace encased_column
