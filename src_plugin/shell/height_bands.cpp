// SPDX-License-Identifier: GPL-2.0-only
#include "shell/height_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

HeightBands::HeightBands(const std::vector<Facet>& facet, const std::vector<Vec3>& position)
{
  const auto heights = [&](const Facet& f) {
    return std::minmax({position[f[0]].z(), position[f[1]].z(), position[f[2]].z()});
  };
  double high = low_ = position.front().z(), sum = 0.0;
  for (const Facet& f : facet) {
    const auto [lowest, highest] = heights(f);
    low_ = std::min(low_, lowest);
    high = std::max(high, highest);
    sum += highest - lowest;
  }
  height_ = std::max(sum / static_cast<double>(facet.size()), 1e-3 * (high - low_));
  const double bands = (high - low_) / height_;
  bands_.resize(bands > 0.0 ? static_cast<std::size_t>(bands) + 1 : 1);  // of no number: one
  for (int n = 0; n < static_cast<int>(facet.size()); ++n) {
    const auto [lowest, highest] = heights(facet[n]);
    for (int b = band_of(lowest); b <= band_of(highest); ++b) bands_[b].facets.push_back(n);
  }
  for (Band& band : bands_) free_middle(band, facet, position);
}

int HeightBands::band_of(double z) const
{
  const double band = (z - low_) / height_;
  if (!(band > 0.0)) return 0;
  return band < size() ? static_cast<int>(band) : size() - 1;
}

double HeightBands::square_distance(const Band& band, const Vec3& point)
{
  const double x = point.x() - band.x, y = point.y() - band.y;
  return x * x + y * y;
}

// A facet lies in a circle about its center of gravity.
void HeightBands::free_middle(Band& band, const std::vector<Facet>& facet,
                              const std::vector<Vec3>& position)
{
  if (band.facets.empty()) return;
  const auto center = [&](int n) -> Vec3 {
    const Facet& f = facet[n];
    return (position[f[0]] + position[f[1]] + position[f[2]]) / 3.0;
  };
  Vec3 middle = Vec3::Zero();
  for (const int n : band.facets) middle += center(n) / static_cast<double>(band.facets.size());
  band.x = middle.x();
  band.y = middle.y();
  double free = std::numeric_limits<double>::infinity();
  for (const int n : band.facets) {
    double size = 0.0;
    for (const int node : facet[n])
      size = std::max(size, (position[node] - center(n)).head<2>().norm());
    free = std::min(free, std::sqrt(square_distance(band, center(n))) - size);
  }
  band.free = std::max(free, 0.0);
}

bool HeightBands::is_clear(const Vec3& point, double reach) const
{
  const int last = band_of(point.z() + reach);
  for (int b = band_of(point.z() - reach); b <= last; ++b) {
    const double room = bands_[b].free - reach;
    if (!(room > 0.0) || square_distance(bands_[b], point) >= room * room) return false;
  }
  return true;
}

}  // namespace encased_column
