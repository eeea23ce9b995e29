#include "shell/level_cut.h"

#include <limits>

namespace encased_column {

InsideTest::InsideTest(const std::vector<Facet>& facet, const std::vector<Vec3>& position)
    : facet_(facet),
      position_(position)
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
  bands_.resize(static_cast<std::size_t>((high - low_) / height_) + 1);
  for (int n = 0; n < static_cast<int>(facet.size()); ++n) {
    const auto [lowest, highest] = heights(facet[n]);
    for (int b = band_of(lowest); b <= band_of(highest); ++b) bands_[b].facets.push_back(n);
  }
  // Towards an open end a ray may pass above the surface.
  for (int b = 1; b + 1 < static_cast<int>(bands_.size()); ++b) find_core(b);
}

void InsideTest::find_core(int number)
{
  Band& band = bands_[number];
  if (band.facets.empty()) return;
  const auto middle = [&](int n) -> Vec3 {
    const Facet& f = facet_[n];
    return (position_[f[0]] + position_[f[1]] + position_[f[2]]) / 3.0;
  };
  Vec3 center = Vec3::Zero();
  for (const int n : band.facets) center += middle(n) / static_cast<double>(band.facets.size());
  double radius = std::numeric_limits<double>::infinity();
  for (const int n : band.facets) {
    double size = 0.0;
    for (const int node : facet_[n])
      size = std::max(size, (position_[node] - middle(n)).head<2>().norm());
    radius = std::min(radius, (middle(n) - center).head<2>().norm() - size);
  }
  for (const double part : {0.01, 0.5, 0.99}) {
    center.z() = low_ + (number + part) * height_;
    if (!(radius > 0.0) || !is_inside(center, band)) return;
  }
  band.x = center.x();
  band.y = center.y();
  band.core_square = radius * radius;
}

int InsideTest::band_of(double z) const
{
  const double band = (z - low_) / height_;
  if (!(band > 0.0)) return 0;
  return std::min(static_cast<int>(band), static_cast<int>(bands_.size()) - 1);
}

bool InsideTest::is_inside(const Vec3& point) const
{
  const Band& band = bands_[band_of(point.z())];
  const double x = point.x() - band.x, y = point.y() - band.y;
  return x * x + y * y < band.core_square || is_inside(point, band);
}

bool InsideTest::is_inside(const Vec3& point, const Band& band) const
{
  bool inside = false;
  for (const int n : band.facets)
    cut_facet(facet_[n], position_, point.z(), [&](const Vec3& a, const Vec3& b) {
      if ((a.y() > point.y()) == (b.y() > point.y())) return;
      const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > point.x()) inside = !inside;
    });
  return inside;
}

}  // namespace encased_column
