// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/height_bands.h"
#include "shell/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// Calls `found(a, b)` with the ends [m] of the piece in which the level plane at `z` [m] cuts the
/// facet, if it does, anticlockwise around the inside (outward facets). The plane should miss the
/// nodes: between two rings it meets every facet of the strip once.
template <typename Found>
void cut_facet(const Facet& f, const std::vector<Vec3>& position, double z, const Found& found)
{
  const Vec3* corner[3] = {&position[f[0]], &position[f[1]], &position[f[2]]};
  const bool above[3] = {corner[0]->z() > z, corner[1]->z() > z, corner[2]->z() > z};
  if (above[0] == above[1] && above[1] == above[2]) return;
  Vec3 up = Vec3::Zero(), down = Vec3::Zero();  // where the border of the facet goes up and down
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (above[i] == above[j]) continue;
    const double part = (z - corner[i]->z()) / (corner[j]->z() - corner[i]->z());
    (above[j] ? up : down) = *corner[i] + part * (*corner[j] - *corner[i]);
  }
  found(down, up);
}

/// Area [m^2] inside the lateral surface at the height `z` [m]: half the sum of a x b over the
/// pieces.
inline double area_at_level(const std::vector<Facet>& facet, const std::vector<Vec3>& position,
                            double z)
{
  double twice = 0.0;
  for (const Facet& f : facet)
    cut_facet(f, position, z,
              [&](const Vec3& a, const Vec3& b) { twice += a.x() * b.y() - a.y() * b.x(); });
  return 0.5 * std::abs(twice);
}

/// A lateral surface sorted by height, to ask for many points which side they are on.
class InsideTest {
 public:
  /// Sorts the facets as they lie now.
  InsideTest(const std::vector<Facet>& facet, const std::vector<Vec3>& position);

  /// True where the point is inside at its own height: a ray along x crosses the pieces an odd
  /// number of times.
  bool is_inside(const Vec3& point) const;

 private:
  bool is_beside(const Facet& f, double y) const;
  bool is_inside(const Vec3& point, int band) const;

  const std::vector<Facet>& facet_;
  const std::vector<Vec3>& position_;
  HeightBands bands_;
  std::vector<char> has_core_;  ///< the free middle of the band is inside: most points ask no more
};

}  // namespace encased_column
