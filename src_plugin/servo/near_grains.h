// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/grain_reach.h"
#include "core/vec3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// The grains that may touch a rigid wall until the host makes its lists of pairs again. Grains
/// keep their numbers in between.
class NearGrains {
 public:
  /// Lists those grains of `count` that are near `shape` and that `counts(i)`. A grain is inside
  /// its `reach` around where the last list of pairs found it, so it moves less than twice that
  /// after this list, and the wall half a skin: see is_stale(). Centers in a row of triples and
  /// radii [m]; `position` [m] says where the wall is.
  template <typename Shape, typename Counts>
  void list(const Shape& shape, double position, const GrainReach& reach, const double* centers,
            const double* radii, int count, const Counts& counts)
  {
    numbers_.clear();
    listed_position_ = position;
    for (int i = 0; i < count; ++i)
      if (counts(i) && shape.touches(centers + 3 * i, radii[i] + reach.margin(i)))
        numbers_.push_back(i);
  }
  bool is_stale(double position, double skin) const
  {
    return std::abs(position - listed_position_) > 0.5 * skin;
  }

  const std::vector<int>& numbers() const { return numbers_; }

  /// Calls `found(n, overlap, normal)` for every grain numbers()[n] that touches the wall. Those
  /// are picked out first, without a branch: which ones touch cannot be guessed, and a wrong guess
  /// waits for memory.
  template <typename Shape, typename Found>
  void find_touching(const Shape& shape, const double* centers, const double* radii,
                     const Found& found) const
  {
    constexpr int most = 64;
    int touching[most];
    const int all = static_cast<int>(numbers_.size());
    for (int first = 0; first < all; first += most) {
      int number = 0;
      for (int n = first; n < std::min(first + most, all); ++n) {
        touching[number] = n;
        number += shape.touches(centers + 3 * numbers_[n], radii[numbers_[n]]);
      }
      for (int m = 0; m < number; ++m) {
        const int i = numbers_[touching[m]];
        const double* const center = centers + 3 * i;
        found(touching[m], std::max(shape.overlap(center, radii[i]), 0.0), shape.normal(center));
      }
    }
  }

 private:
  std::vector<int> numbers_;
  double listed_position_ = 0.0;  ///< of the wall [m]
};

/// Distance [m] from the center of a grain to the wall it overlaps; a center beyond the wall is
/// still pushed back.
inline double distance_to_wall(double radius, double overlap)
{
  return std::max(radius - overlap, 1e-3 * radius);
}

}  // namespace encased_column
