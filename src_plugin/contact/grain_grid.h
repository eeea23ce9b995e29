// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/cell_grid.h"

#include <limits>
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
  /// `center` [m] with `radius` [m], and may for one farther by 2e-7 of its radius.
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
    double center[3];
    float radius;  ///< rounded up, to save memory
    int number;
  };

  static constexpr double rounded_up = 1.0 + std::numeric_limits<float>::epsilon();

  /// Some of the spheres that are sorted, made as they are asked for: copies would be the largest
  /// memory of a list that is being made.
  struct Spheres {
    std::vector<int> numbers;
    const double* centers;
    const double* radii;

    std::size_t size() const { return numbers.size(); }
    Sphere operator[](std::size_t n) const
    {
      const int i = numbers[n];
      const double* const x = centers + 3 * i;
      return {{x[0], x[1], x[2]}, static_cast<float>(rounded_up * radii[i]), i};
    }
  };

  /// The spheres of one class of size.
  struct Level {
    void lay_grid(const Spheres& spheres, double finest_size);

    double largest = 0.0;  ///< radius [m]
    CellGrid<Sphere> grid;
  };

  std::vector<Level> levels_;
};

/// Two of `count` grains whose centers, three numbers each [m], are the same point: no direction
/// leads from one to the other, and no contact law can part them.
std::optional<std::pair<int, int>> find_coincident(const double* centers, int count);

}  // namespace encased_column
