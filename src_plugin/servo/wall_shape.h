// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"
#include "core/vec3.h"

#include <cmath>

namespace encased_column {

/// A plane across the z axis that bounds the specimen above (outward = +1) or below (-1).
struct PlaneShape {
  double z = 0.0;  ///< height of its face [m]
  double outward = 1.0;

  /// Overlap [m] of a sphere with the wall; negative is a gap.
  double overlap(const double* x, double radius) const { return radius - outward * (z - x[2]); }
  /// overlap() > 0.
  bool touches(const double* x, double radius) const { return overlap(x, radius) > 0.0; }
  /// Unit vector from a sphere at `x` to the wall.
  Vec3 normal(const double*) const { return Vec3(0.0, 0.0, outward); }
  /// Moves the face by `distance` [m] towards the specimen.
  void advance(double distance) { z -= outward * distance; }
};

/// The inside of a cylinder about an axis along z.
struct CylinderShape {
  double radius = 0.0;  ///< [m]
  double x = 0.0, y = 0.0;

  /// Overlap [m] of a sphere with the wall; negative is a gap.
  double overlap(const double* center, double r) const
  {
    const double dx = center[0] - x, dy = center[1] - y;
    return std::sqrt(dx * dx + dy * dy) - (radius - r);
  }
  /// overlap() > 0 but for round-off, without a square root.
  bool touches(const double* center, double r) const
  {
    const double dx = center[0] - x, dy = center[1] - y, free = radius - r;
    return static_cast<int>(dx * dx + dy * dy > free * free) | static_cast<int>(free < 0.0);
  }
  Vec3 normal(const double* center) const
  {
    return Vec3(center[0] - x, center[1] - y, 0.0).normalized();
  }
  void advance(double distance) { radius -= distance; }
  double cross_section() const { return pi * radius * radius; }
  /// Inner surface [m^2] of a piece of this height [m], either way.
  double lateral_area(double height) const { return 2.0 * pi * radius * std::abs(height); }
  /// Volume [m^3] inside, between two heights [m].
  double volume(double z_low, double z_high) const { return cross_section() * (z_high - z_low); }
  /// As LateralBoundary::count_outside().
  int count_outside(const double* centers, int count, double z_low, double z_high) const
  {
    int outside = 0;
    for (const double* c = centers; c != centers + 3 * count; c += 3)
      outside += c[2] < z_low || c[2] > z_high || overlap(c, 0.0) >= 0.0;
    return outside;
  }
};

}  // namespace encased_column
