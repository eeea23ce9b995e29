// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <vector>

namespace encased_column {

/// Items sorted into equal cubes by a point of each, to find those in a block without looking at
/// all. How large the cubes are is for its users: see GrainGrid and FacetGrid.
template <typename Item>
class CellGrid {
 public:
  /// Cubes of the edge `size` [m] from the `corner` [m] on, so many along each axis.
  void lay(const Vec3& corner, double size, const int (&cells)[3])
  {
    corner_ = corner;
    size_ = size;
    for (int a = 0; a < 3; ++a) cells_[a] = cells[a];
  }

  /// Sorts `items`, a vector or what makes them one by one; `point(item)` gives three numbers [m].
  /// Those of one cube keep their order, and points outside go to the outermost cubes.
  template <typename Items, typename Point>
  void sort(const Items& items, const Point& point)
  {
    begin_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2] + 2, 0);
    std::vector<int> cell(items.size());
    // Counted two places on, begin[c + 1] runs from the first to the end of cube c while it is
    // filled.
    for (std::size_t n = 0; n < items.size(); ++n) {
      const Item& item = items[n];
      const auto& x = point(item);
      cell[n] = (cell_of(x[2], 2) * cells_[1] + cell_of(x[1], 1)) * cells_[0] + cell_of(x[0], 0);
      ++begin_[cell[n] + 2];
    }
    for (std::size_t c = 2; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    sorted_.resize(items.size());
    for (std::size_t n = 0; n < items.size(); ++n) sorted_[begin_[cell[n] + 1]++] = items[n];
  }

  /// Calls `found(item)` for all items of the cubes within `range` [m] of `x` along each axis.
  template <typename Found>
  void near(const Vec3& x, double range, const Found& found) const
  {
    int low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = cell_of(x(a) - range, a);
      high[a] = cell_of(x(a) + range, a);
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j) {
        const int row = (k * cells_[1] + j) * cells_[0];
        const int end = begin_[row + high[0] + 1];
        for (int n = begin_[row + low[0]]; n < end; ++n) found(sorted_[n]);
      }
  }

  /// False where a point is farther than `range` [m] from all cubes along some axis.
  bool reaches(const Vec3& x, double range) const
  {
    for (int a = 0; a < 3; ++a)
      if (x(a) + range < corner_(a) || x(a) - range > corner_(a) + cells_[a] * size_) return false;
    return true;
  }

 private:
  int cell_of(double coordinate, int axis) const
  {
    const double cell = (coordinate - corner_(axis)) / size_;
    if (!(cell > 0.0)) return 0;
    return cell < cells_[axis] ? static_cast<int>(cell) : cells_[axis] - 1;
  }

  Vec3 corner_ = Vec3::Zero();
  double size_ = 1.0;  ///< edge of a cube [m]
  int cells_[3] = {1, 1, 1};
  std::vector<int> begin_{0, 0};  ///< of each cube's items
  std::vector<Item> sorted_;
};

}  // namespace encased_column
