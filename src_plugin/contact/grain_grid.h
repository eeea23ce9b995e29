// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/cell_grid.h"

#include <optional>
#include <utility>
#include <vector>

namespace encased_column {

/// Spheres of very different sizes, sorted to find those that touch each other: one grid of cubes
/// for every factor of two in size, so that fines are not looked for in cubes as wide as the
/// largest (hierarchical grid, Ogarko and Luding, Comput. Phys. Commun. 183, 2012).
class GrainGrid {
 public:
  /// Sorts `count` spheres with `centers` in a row of triples [m] and `radii` [m].
  void sort(const double* centers, const double* radii, int count);

  /// Calls `found(j)` for every sorted sphere j that is `first` or later and touches one at
  /// `center` [m] with `radius` [m].
  template <typename Found>
  void near(const Vec3& center, double radius, int first, const Found& found) const
  {
    for (const Level& level : levels_) {
      level.grid.near(center, radius + level.largest, [&](const Sphere& other) {
        if (other.number < first) return;
        const double x = other.center[0] - center(0), y = other.center[1] - center(1),
                     z = other.center[2] - center(2);
        const double reach = radius + other.radius;
        if (x * x + y * y + z * z <= reach * reach) found(other.number);
      });
    }
  }

 private:
  struct Sphere {
    double center[3], radius;
    int number;
  };

  /// The spheres of one class of size.
  struct Level {
    void lay_grid(const std::vector<Sphere>& spheres, double finest_size);

    double largest = 0.0;  ///< radius [m]
    CellGrid<Sphere> grid;
  };

  std::vector<Level> levels_;
  std::vector<std::vector<Sphere>> classes_;  ///< empty between
};

/// Two of `count` grains whose centers, three numbers each [m], are the same point: no direction
/// leads from one to the other, and no contact law can part them.
std::optional<std::pair<int, int>> find_coincident(const double* centers, int count);

}  // namespace encased_column
