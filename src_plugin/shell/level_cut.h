#pragma once

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
  /// Sorts the facets as they lie now, into bands about as high as one.
  InsideTest(const std::vector<Facet>& facet, const std::vector<Vec3>& position);

  /// True where the point is inside at its own height: a ray along x crosses the pieces an odd
  /// number of times.
  bool is_inside(const Vec3& point) const;

 private:
  /// Facets of a range of height, and a cylinder about (x, y) [m] that is inside over all of it:
  /// most points ask no more. Its radius is 0 where there is none.
  struct Band {
    std::vector<int> facets;
    double x = 0.0, y = 0.0, core_square = 0.0;  ///< radius squared [m^2]
  };

  int band_of(double z) const;
  void find_core(int band);
  bool is_inside(const Vec3& point, const Band& band) const;

  const std::vector<Facet>& facet_;
  const std::vector<Vec3>& position_;
  double low_ = 0.0, height_ = 1.0;  ///< lower end, and height of a band [m]
  std::vector<Band> bands_;
};

}  // namespace encased_column
