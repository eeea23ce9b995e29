// SPDX-License-Identifier: GPL-2.0-only
#include "shell/height_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

using Vec2 = Eigen::Vector2d;

namespace {

double cross(const Vec2& a, const Vec2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Square of the distance [m^2] from the origin to the straight line from `a` to `b`.
double square_to_line(const Vec2& a, const Vec2& b)
{
  const Vec2 way = b - a;
  const double length_square = way.squaredNorm();
  const double part = length_square > 0.0 ? std::clamp(-a.dot(way) / length_square, 0.0, 1.0) : 0.0;
  return (a + part * way).squaredNorm();
}

/// The same to a triangle, zero inside it.
double square_to_triangle(const Vec2& a, const Vec2& b, const Vec2& c)
{
  const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  if ((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)) return 0.0;
  return std::min({square_to_line(a, b), square_to_line(b, c), square_to_line(c, a)});
}

}  // namespace

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

void HeightBands::free_middle(Band& band, const std::vector<Facet>& facet,
                              const std::vector<Vec3>& position)
{
  if (band.facets.empty()) return;
  Vec2 middle = Vec2::Zero();
  for (const int n : band.facets)
    for (const int node : facet[n])
      middle += position[node].head<2>() / (3.0 * static_cast<double>(band.facets.size()));
  band.x = middle.x();
  band.y = middle.y();
  double square = std::numeric_limits<double>::infinity();
  for (const int n : band.facets) {
    const Facet& f = facet[n];
    square = std::min(square, square_to_triangle(position[f[0]].head<2>() - middle,
                                                 position[f[1]].head<2>() - middle,
                                                 position[f[2]].head<2>() - middle));
  }
  band.free = std::sqrt(square);
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
