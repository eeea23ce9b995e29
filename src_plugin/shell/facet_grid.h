#pragma once

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
    int low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = cell_of(x(a) - range, a);
      high[a] = cell_of(x(a) + range, a);
      if (x(a) + range < corner_(a) || x(a) - range > corner_(a) + cells_[a] * size_) return;
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j) {
        const int row = (k * cells_[1] + j) * cells_[0];
        for (int n = begin_[row + low[0]]; n < begin_[row + high[0] + 1]; ++n) found(sorted_[n]);
      }
  }

 private:
  int cell_of(double coordinate, int axis) const
  {
    const double cell = (coordinate - corner_(axis)) / size_;
    if (!(cell > 0.0)) return 0;
    return cell < cells_[axis] ? static_cast<int>(cell) : cells_[axis] - 1;
  }

  Vec3 corner_ = Vec3::Zero();
  double size_ = 1.0;            ///< edge of a cube [m]
  double largest_radius_ = 0.0;  ///< of the facets' bounding spheres [m]
  int cells_[3] = {1, 1, 1};
  std::vector<int> begin_{0, 0}, sorted_, cell_;
};

}  // namespace encased_column
