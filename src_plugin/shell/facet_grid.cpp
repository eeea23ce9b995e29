#include "shell/facet_grid.h"

#include <algorithm>
#include <cmath>

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
  Vec3 high = center_of(facet.front(), position);
  corner_ = high;
  double square = 0.0;
  for (const Facet& f : facet) {
    const Vec3 center = center_of(f, position);
    corner_ = corner_.cwiseMin(center);
    high = high.cwiseMax(center);
    for (const int node : f) square = std::max(square, (position[node] - center).squaredNorm());
  }
  largest_radius_ = std::sqrt(square);
  // Cubes about as large as a facet; larger ones where a few small facets span a large space.
  const Vec3 extent = high - corner_;
  size_ = std::max(2.0 * largest_radius_, std::cbrt(extent.prod() / most_cells));
  const auto cells_along = [&](int a) { return 1.0 + std::floor(extent(a) / size_); };
  while (cells_along(0) * cells_along(1) * cells_along(2) > 2.0 * most_cells) size_ *= 2.0;
  for (int a = 0; a < 3; ++a) {
    const double cells = extent(a) / size_;
    cells_[a] = cells < most_cells ? 1 + static_cast<int>(cells) : 1;  // of no number: one
  }

  const std::size_t cells = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
  begin_.assign(cells + 1, 0);
  cell_.resize(facet.size());
  sorted_.resize(facet.size());
  for (std::size_t f = 0; f < facet.size(); ++f) {
    const Vec3 center = center_of(facet[f], position);
    cell_[f] = (cell_of(center.z(), 2) * cells_[1] + cell_of(center.y(), 1)) * cells_[0] +
               cell_of(center.x(), 0);
    ++begin_[cell_[f] + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) begin_[c + 1] += begin_[c];
  std::vector<int> filled(begin_.begin(), begin_.end() - 1);
  for (std::size_t f = 0; f < facet.size(); ++f) sorted_[filled[cell_[f]]++] = static_cast<int>(f);
}

}  // namespace encased_column
