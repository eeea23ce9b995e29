// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

/// Volume [m^3] of a sphere of radius `r` [m].
inline double sphere_volume(double r)
{
  return 4.0 / 3.0 * pi * r * r * r;
}

/// Volume [m^3] shared by two spheres of radii `a` and `b` [m], centers `d` [m] apart.
///
/// Zero when they do not touch, the smaller sphere when it lies inside the larger,
/// otherwise the lens
///
///   V = pi (a + b - d)^2 [d^2 + 2 d (a + b) - 3 (a - b)^2] / (12 d),
///
/// which meets both limits continuously.
/// Source: Weisstein, "Sphere-Sphere Intersection", MathWorld, eq. (16); terms regrouped
/// to show the symmetry in a and b.
/// Requires a, b, d >= 0 and finite: checked once where they are read, not in this loop.
inline double sphere_overlap_volume(double a, double b, double d)
{
  const double sum = a + b;
  const double difference = std::abs(a - b);
  if (d >= sum) return 0.0;
  if (d <= difference) return sphere_volume(std::min(a, b));

  const double depth = sum - d;
  return pi * depth * depth * (d * d + 2.0 * d * sum - 3.0 * difference * difference) / (12.0 * d);
}

/// Volume [m^3] of the cap a sphere of radius `r` [m] shows behind a plane `d` [m] from its center.
/// Source: Weisstein, "Spherical Cap", MathWorld, eq. (3).
inline double sphere_cap_volume(double r, double d)
{
  const double depth = std::clamp(r - d, 0.0, 2.0 * r);
  return pi * depth * depth * (3.0 * r - depth) / 3.0;
}

}  // namespace encased_column
