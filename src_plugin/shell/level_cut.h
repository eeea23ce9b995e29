#pragma once

#include "shell/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// Calls `found(a, b)` for every piece of the lateral surface that the level plane at `z` [m] cuts,
/// as its two ends [m], anticlockwise around the inside (outward facets). The plane should miss the
/// nodes: between two rings it meets every facet of the strip once.
template <typename Found>
void cut_at_level(const std::vector<Facet>& facet, const std::vector<Vec3>& position, double z,
                  const Found& found)
{
  for (const Facet& f : facet) {
    const Vec3* corner[3] = {&position[f[0]], &position[f[1]], &position[f[2]]};
    const bool above[3] = {corner[0]->z() > z, corner[1]->z() > z, corner[2]->z() > z};
    if (above[0] == above[1] && above[1] == above[2]) continue;
    Vec3 up = Vec3::Zero(), down = Vec3::Zero();  // where the border of the facet goes up and down
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (above[i] == above[j]) continue;
      const double part = (z - corner[i]->z()) / (corner[j]->z() - corner[i]->z());
      (above[j] ? up : down) = *corner[i] + part * (*corner[j] - *corner[i]);
    }
    found(down, up);
  }
}

/// Area [m^2] inside the lateral surface at the height `z` [m]: half the sum of a x b over the
/// pieces.
inline double area_at_level(const std::vector<Facet>& facet, const std::vector<Vec3>& position,
                            double z)
{
  double twice = 0.0;
  cut_at_level(facet, position, z,
               [&](const Vec3& a, const Vec3& b) { twice += a.x() * b.y() - a.y() * b.x(); });
  return 0.5 * std::abs(twice);
}

/// True where the point is inside the lateral surface at its own height: a ray along x crosses the
/// pieces an odd number of times.
inline bool is_inside(const std::vector<Facet>& facet, const std::vector<Vec3>& position,
                      const Vec3& point)
{
  bool inside = false;
  cut_at_level(facet, position, point.z(), [&](const Vec3& a, const Vec3& b) {
    if ((a.y() > point.y()) == (b.y() > point.y())) return;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > point.x()) inside = !inside;
  });
  return inside;
}

}  // namespace encased_column
