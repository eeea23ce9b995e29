// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/surface_mesh.h"

#include <cmath>
#include <vector>

namespace encased_column {

/// Facets of an upright sleeve about `axis` that a line along the axis at `angle` [rad] from x, the
/// short way round, passes through: those with nodes on both its sides. Whatever the mesh, they
/// part the sleeve along the line.
inline std::vector<int> facets_on_line(const std::vector<Facet>& facet,
                                       const std::vector<Vec3>& node, const Vec3& axis,
                                       double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<int> on_line;
  for (std::size_t f = 0; f < facet.size(); ++f) {
    bool left = false, right = false, this_half = true;
    for (const int n : facet[f]) {
      const double x = node[n].x() - axis.x(), y = node[n].y() - axis.y();
      if (x * c + y * s <= 0.0) this_half = false;
      (y * c - x * s < 0.0 ? right : left) = true;
    }
    if (left && right && this_half) on_line.push_back(static_cast<int>(f));
  }
  return on_line;
}

}  // namespace encased_column
