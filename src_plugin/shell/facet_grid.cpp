// SPDX-License-Identifier: GPL-2.0-only
#include "shell/facet_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace encased_column {

namespace {

constexpr double most_cells = 2e6;

Vec3 center_of(const Facet& f, const std::vector<Vec3>& position)
{
  return (position[f[0]] + position[f[1]] + position[f[2]]) / 3.0;
}

}  // namespace

void FacetGrid::sort(const std::vector<Facet>& facet, const std::vector<Vec3>& position)
{
  Vec3 low = center_of(facet.front(), position), high = low;
  double largest = 0.0;
  spheres_.clear();
  for (const Facet& f : facet) {
    const Vec3 center = center_of(f, position);
    low = low.cwiseMin(center);
    high = high.cwiseMax(center);
    double square = 0.0;
    for (const int node : f) square = std::max(square, (position[node] - center).squaredNorm());
    largest = std::max(largest, square);
    spheres_.push_back({center, (1.0 + 1e-12) * std::sqrt(square)});
  }
  largest_radius_ = (1.0 + 1e-12) * std::sqrt(largest);
  // Cubes about as large as a facet; larger ones where a few small facets span a large space.
  const Vec3 extent = high - low;
  double size = std::max(2.0 * largest_radius_, std::cbrt(extent.prod() / most_cells));
  const auto cells_along = [&](int a) { return 1.0 + std::floor(extent(a) / size); };
  while (cells_along(0) * cells_along(1) * cells_along(2) > 2.0 * most_cells) size *= 2.0;
  int cells[3];
  for (int a = 0; a < 3; ++a) {
    const double wanted = extent(a) / size;
    cells[a] = wanted < most_cells ? 1 + static_cast<int>(wanted) : 1;  // of no number: one
  }
  grid_.lay(low, size, cells);
  std::vector<int> numbers(facet.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  grid_.sort(numbers, [&](int f) -> const Vec3& { return spheres_[f].center; });
}

}  // namespace encased_column
