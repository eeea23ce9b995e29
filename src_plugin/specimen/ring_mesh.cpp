// SPDX-License-Identifier: GPL-2.0-only
#include "specimen/ring_mesh.h"

#include "core/constants.h"

#include <cmath>

namespace encased_column {

SurfaceMesh mesh_of(const Rings& rings)
{
  const int around = rings.around, rows = rings.rows;
  const auto is_turned = [&](int ring) { return rings.staggered && ring % 2 == 1; };
  SurfaceMesh mesh;
  mesh.node.reserve(static_cast<std::size_t>(around) * (rows + 1));
  mesh.facet.reserve(2 * static_cast<std::size_t>(around) * rows);
  for (int ring = 0; ring <= rows; ++ring)
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * pi * (i + (is_turned(ring) ? 0.5 : 0.0)) / around;
      mesh.node.emplace_back(rings.center_x + rings.radius * std::cos(angle),
                             rings.center_y + rings.radius * std::sin(angle),
                             rings.bottom + rings.height * ring / rows);
    }
  for (int ring = 0; ring < rows; ++ring)
    for (int i = 0; i < around; ++i) {
      const int j = (i + 1) % around;
      const int low = ring * around, high = low + around;
      if (is_turned(ring + 1)) {  // the upper ring is half an edge ahead
        mesh.facet.push_back({low + i, low + j, high + i});
        mesh.facet.push_back({low + j, high + j, high + i});
      } else {
        mesh.facet.push_back({low + i, low + j, high + j});
        mesh.facet.push_back({low + i, high + j, high + i});
      }
    }
  return mesh;
}

}  // namespace encased_column
