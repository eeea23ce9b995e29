#pragma once

#include "core/vec3.h"

#include <optional>
#include <utility>
#include <vector>

namespace encased_column {

/// Spheres of very different sizes, sorted to find those near each other: one grid of cubes for
/// every factor of two in size, so that fines are not looked for in cubes as wide as the largest
/// (hierarchical grid, Ogarko and Luding, Comput. Phys. Commun. 183, 2012).
class GrainGrid {
 public:
  /// Sorts `count` spheres with `centers` in a row of triples [m] and `radii` [m], to find those
  /// that come as near as factor (r_i + r_j) + margin [m].
  void sort(const double* centers, const double* radii, int count, double factor, double margin);

  /// Calls `found(j)` for every sorted sphere j that is `first` or later and as near to one at
  /// `center` [m] with `radius` [m].
  template <typename Found>
  void near(const Vec3& center, double radius, int first, const Found& found) const
  {
    for (const Level& level : levels_) {
      const double range = factor_ * (radius + level.largest) + margin_;
      int low[3], high[3];
      for (int a = 0; a < 3; ++a) {
        low[a] = level.cell_of(center(a) - range, a);
        high[a] = level.cell_of(center(a) + range, a);
      }
      for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j) {
          const int row = (k * level.cells[1] + j) * level.cells[0];
          const int end = level.begin[row + high[0] + 1];
          for (int n = level.begin[row + low[0]]; n < end; ++n) {
            const Sphere& other = level.sorted[n];
            if (other.number < first) continue;
            const double x = other.center[0] - center(0), y = other.center[1] - center(1),
                         z = other.center[2] - center(2);
            const double reach = factor_ * (radius + other.radius) + margin_;
            if (x * x + y * y + z * z <= reach * reach) found(other.number);
          }
        }
    }
  }

 private:
  struct Sphere {
    double center[3], radius;
    int number;
  };

  /// The spheres of one class of size, sorted by cubes; begin[c] is the first of cube c.
  struct Level {
    int cell_of(double coordinate, int axis) const
    {
      const double cell = (coordinate - corner(axis)) / size;
      if (!(cell > 0.0)) return 0;
      return cell < cells[axis] ? static_cast<int>(cell) : cells[axis] - 1;
    }
    int cell_of(const Sphere& sphere) const
    {
      return (cell_of(sphere.center[2], 2) * cells[1] + cell_of(sphere.center[1], 1)) * cells[0] +
             cell_of(sphere.center[0], 0);
    }
    void lay_grid(const std::vector<Sphere>& spheres, double finest_size);
    void sort(const std::vector<Sphere>& spheres);

    double largest = 0.0;  ///< radius [m]
    Vec3 corner = Vec3::Zero();
    double size = 1.0;  ///< edge of a cube [m]
    int cells[3] = {1, 1, 1};
    std::vector<int> begin;
    std::vector<Sphere> sorted;
  };

  double factor_ = 1.0, margin_ = 0.0;
  std::vector<Level> levels_;
  std::vector<std::vector<Sphere>> classes_;  ///< kept for their memory
};

/// Two of `count` grains whose centers, three numbers each [m], are the same point: no direction
/// leads from one to the other, and no contact law can part them.
std::optional<std::pair<int, int>> find_coincident(const double* centers, int count);

}  // namespace encased_column
