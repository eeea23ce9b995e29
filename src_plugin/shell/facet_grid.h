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

  /// Calls `found(facet)` for every facet whose bounding sphere comes within `reach` [m] of `x`,
  /// and for some others near by.
  template <typename Found>
  void near(const Vec3& x, double reach, const Found& found) const
  {
    const double range = reach + largest_radius_;
    if (grid_.reaches(x, range)) grid_.near(x, range, found);
  }

 private:
  double largest_radius_ = 0.0;  ///< of the facets' bounding spheres [m]
  CellGrid<int> grid_;
};

}  // namespace encased_column
