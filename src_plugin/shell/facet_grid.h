// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/cell_grid.h"
#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// Facets sorted into cubes by their centers, to find those near a point without looking at all.
class FacetGrid {
 public:
  /// Sorts the facets as they lie now.
  void sort(const std::vector<Facet>& facet, const std::vector<Vec3>& position);

  /// Calls `found(facet)` for every facet whose bounding sphere comes within `reach` [m] of `x`.
  template <typename Found>
  void near(const Vec3& x, double reach, const Found& found) const
  {
    const double range = reach + largest_radius_;
    if (!grid_.reaches(x, range)) return;
    grid_.near(x, range, [&](int f) {
      const double far = reach + spheres_[f].radius;
      if (!((spheres_[f].center - x).squaredNorm() > far * far)) found(f);
    });
  }

 private:
  struct Sphere {
    Vec3 center;
    double radius;  ///< [m]
  };

  std::vector<Sphere> spheres_;  ///< about each facet
  double largest_radius_ = 0.0;  ///< of them [m]
  CellGrid<int> grid_;
};

}  // namespace encased_column
