// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace encased_column {

namespace {

constexpr int most_levels = 8;        ///< the last one takes all that are smaller still
constexpr long cells_per_sphere = 8;  ///< more would cost more to clear than they save
constexpr long cells_at_least = 4096;

}  // namespace

void GrainGrid::Level::lay_grid(const Spheres& spheres, double finest_size)
{
  Vec3 low = as_vec3(spheres[0].center), high = low;
  for (int i : spheres.numbers) {
    low = low.cwiseMin(as_vec3(spheres.centers + 3 * i));
    high = high.cwiseMax(as_vec3(spheres.centers + 3 * i));
  }
  double size = finest_size;
  int cells[3] = {1, 1, 1};
  if ((high - low).allFinite()) {  // other checks stop a run that blew up
    const long most =
        std::max(cells_at_least, cells_per_sphere * static_cast<long>(spheres.size()));
    for (;; size *= 1.26) {  // twice the volume of a cube
      double wanted = 1.0;
      for (int a = 0; a < 3; ++a) wanted *= std::floor((high(a) - low(a)) / size) + 1.0;
      if (wanted <= static_cast<double>(most)) break;
    }
    for (int a = 0; a < 3; ++a) cells[a] = static_cast<int>((high(a) - low(a)) / size) + 1;
  }
  grid.lay(low, size, cells);
}

void GrainGrid::sort(const double* centers, const double* radii, int count)
{
  const double largest = count > 0 ? *std::max_element(radii, radii + count) : 0.0;
  const auto level_of = [&](int i) {
    return std::min(most_levels - 1, std::ilogb(largest / radii[i]));
  };
  std::vector<Spheres> classes(most_levels, {{}, centers, radii});
  for (int i = 0; i < count; ++i) classes[level_of(i)].numbers.push_back(i);
  std::size_t used = 0;
  for (Spheres& spheres : classes) {
    if (spheres.size() == 0) continue;
    if (used == levels_.size()) levels_.emplace_back();
    Level& level = levels_[used++];
    level.largest = 0.0;
    for (int i : spheres.numbers) level.largest = std::max(level.largest, radii[i]);
    level.lay_grid(spheres, 2.0 * level.largest);
    level.grid.sort(
        spheres, [](const Sphere& sphere) -> auto& { return sphere.center; });
    spheres.numbers = std::vector<int>();
  }
  levels_.resize(used);
}

std::optional<std::pair<int, int>> find_coincident(const double* centers, int count)
{
  struct Grain {
    std::array<double, 3> center;
    int index;
  };
  std::vector<Grain> grains;
  for (int i = 0; i < count; ++i) {
    const double* x = centers + 3 * i;
    // Those that are no numbers have no order.
    if (std::isfinite(x[0] + x[1] + x[2])) grains.push_back({{x[0], x[1], x[2]}, i});
  }
  std::sort(grains.begin(), grains.end(),
            [](const Grain& a, const Grain& b) { return a.center < b.center; });
  const auto same =
      std::adjacent_find(grains.begin(), grains.end(),
                         [](const Grain& a, const Grain& b) { return a.center == b.center; });
  if (same == grains.end()) return {};
  return std::minmax(same->index, (same + 1)->index);
}

}  // namespace encased_column
