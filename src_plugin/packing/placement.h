// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cstdint>
#include <vector>

namespace encased_column {

/// An upright cylinder around the z axis.
struct Cylinder {
  double radius;  ///< [m]
  double z_low;   ///< [m]
  double z_high;  ///< [m]

  double height() const { return z_high - z_low; }
  double volume() const;  ///< [m^3]
};

/// Centers [m] of spheres of the given `radii` [m], at random inside `cylinder` and without
/// overlap. Requires `radii` sorted from large to small: large spheres find no room later.
///
/// Each center is drawn uniformly in the part of the cylinder it fits in until it meets no sphere
/// placed before (random sequential addition).
/// Throws InputError when a sphere does not fit the cylinder, or finds no room in 20 000 tries.
std::vector<Vec3> place_spheres(const std::vector<double>& radii, const Cylinder& cylinder,
                                std::uint64_t seed);

}  // namespace encased_column
