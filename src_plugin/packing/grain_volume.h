// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"

#include <vector>

namespace encased_column {

/// Volume [m^3] of a grain of diameter `d` [m].
inline double grain_volume(double d)
{
  return pi / 6.0 * d * d * d;
}

/// Mass [kg] of a grain of `radius` [m] and `density` [kg/m^3].
inline double grain_mass(double radius, double density)
{
  return density * grain_volume(2.0 * radius);
}

/// Volume [m^3] of all grains.
inline double volume_of(const std::vector<double>& diameters)
{
  double volume = 0.0;
  for (const double d : diameters) volume += grain_volume(d);
  return volume;
}

/// Porosity [-] of grains in `total_volume` [m^3]; where they overlap, they count twice.
inline double porosity_of(const std::vector<double>& diameters, double total_volume)
{
  return 1.0 - volume_of(diameters) / total_volume;
}

}  // namespace encased_column
