// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/linear_ramp.h"
#include "shell/height_window.h"
#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// Area times unit normal of a facet [m^2].
inline Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * (b - a).cross(c - a);
}

/// Adds the force of a pressure [Pa] that pushes facets [first, last) along their current normals,
/// where they lie in the window, to the nodal forces [N]. Negative pressure pushes against the
/// normals. For a whole facet each node takes p A / 3, which is the exact gradient of p times the
/// enclosed volume.
void add_pressure(const std::vector<Facet>& facet, const std::vector<Vec3>& position, int first,
                  int last, double pressure, const HeightWindow& window, std::vector<Vec3>& force);

/// Pressure [Pa] on a sleeve.
using PressureRamp = LinearRamp;

}  // namespace encased_column
