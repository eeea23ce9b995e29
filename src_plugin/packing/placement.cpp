// SPDX-License-Identifier: GPL-2.0-only
#include "packing/placement.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "packing/uniform_random.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace encased_column {

namespace {

constexpr int tries_per_sphere = 20000;

/// Spheres sorted into cubes at least as wide as the largest: a sphere can only meet those of its
/// own cube and the 26 around it.
class CellGrid {
 public:
  CellGrid(const Cylinder& cylinder, const std::vector<double>& radii) : radii_(radii)
  {
    // Cubes narrower than the mean distance of spheres would only cost memory.
    const double spacing = std::cbrt(cylinder.volume() / static_cast<double>(radii.size()));
    width_ = std::max(2.0 * radii.front(), spacing);
    low_ = Vec3(-cylinder.radius, -cylinder.radius, cylinder.z_low);
    const Vec3 size(2.0 * cylinder.radius, 2.0 * cylinder.radius, cylinder.height());
    for (int k = 0; k < 3; ++k) cells_[k] = static_cast<int>(size[k] / width_) + 1;
    first_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], -1);
  }

  bool is_free(const Vec3& center, double radius, const std::vector<Vec3>& placed) const
  {
    int from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      const int here = cell(center, k);
      from[k] = std::max(here - 1, 0);
      to[k] = std::min(here + 1, cells_[k] - 1);
    }
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x)
          for (int other = first_[index(x, y, z)]; other >= 0; other = next_[other]) {
            const double apart = radius + radii_[other];
            if ((placed[other] - center).squaredNorm() < apart * apart) return false;
          }
    return true;
  }

  /// Enters the next sphere; spheres are entered in the order of `radii`.
  void add(const Vec3& center)
  {
    int& first = first_[index(cell(center, 0), cell(center, 1), cell(center, 2))];
    next_.push_back(first);
    first = static_cast<int>(next_.size()) - 1;
  }

 private:
  int cell(const Vec3& center, int k) const
  {
    return std::clamp(static_cast<int>((center[k] - low_[k]) / width_), 0, cells_[k] - 1);
  }
  std::size_t index(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * cells_[1] + y) * cells_[0] + x;
  }

  const std::vector<double>& radii_;
  double width_;
  Vec3 low_;
  int cells_[3];
  std::vector<int> first_;  // newest sphere of each cube,
  std::vector<int> next_;   // and of each sphere the one entered before it there; -1 ends
};

Vec3 random_center(const Cylinder& cylinder, double radius, UniformRandom& random)
{
  // A draw from the square, repeated until it falls in the circle, needs no sine: the same digits
  // on every platform.
  const double reach = cylinder.radius - radius;
  double x, y;
  do {
    x = reach * (2.0 * random() - 1.0);
    y = reach * (2.0 * random() - 1.0);
  } while (x * x + y * y > reach * reach);
  return Vec3(x, y, cylinder.z_low + radius + (cylinder.height() - 2.0 * radius) * random());
}

}  // namespace

double Cylinder::volume() const
{
  return pi * radius * radius * height();
}

std::vector<Vec3> place_spheres(const std::vector<double>& radii, const Cylinder& cylinder,
                                std::uint64_t seed)
{
  if (radii.empty()) return {};
  if (radii.front() > cylinder.radius || 2.0 * radii.front() > cylinder.height())
    throw InputError("'cylinder' must hold the largest grain, which has a radius of " +
                     in_words(radii.front()) + " m when placed, found radius " +
                     in_words(cylinder.radius) + " m and height " + in_words(cylinder.height()) +
                     " m, write a larger cylinder");
  UniformRandom random(seed);
  CellGrid grid(cylinder, radii);
  std::vector<Vec3> centers;
  centers.reserve(radii.size());
  for (const double radius : radii) {
    int tries = 0;
    Vec3 center = random_center(cylinder, radius, random);
    while (!grid.is_free(center, radius, centers)) {
      if (++tries == tries_per_sphere)
        throw InputError("'start_factor' leaves no room for grain " +
                         std::to_string(centers.size() + 1) + " of " +
                         std::to_string(radii.size()) + " in " + std::to_string(tries_per_sphere) +
                         " tries, write a smaller one, for example 'start_factor 0.5'");
      center = random_center(cylinder, radius, random);
    }
    centers.push_back(center);
    grid.add(center);
  }
  return centers;
}

}  // namespace encased_column
