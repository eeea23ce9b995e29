// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cmath>

namespace encased_column {

/// Radius over full radius [-] after the part `done` (0 to 1) of a growth from `start`: the solid
/// volume grows evenly, so that the last stages, where grains press, are the small ones.
inline double growth_factor(double start, double done)
{
  const double first = start * start * start;
  return done >= 1.0 ? 1.0 : std::cbrt(first + (1.0 - first) * done);
}

}  // namespace encased_column
