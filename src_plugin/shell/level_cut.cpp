#include "shell/level_cut.h"

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
    for (int b = band_of(lowest); b <= band_of(highest); ++b) bands_[b].push_back(n);
  }
}

int InsideTest::band_of(double z) const
{
  const double band = (z - low_) / height_;
  if (!(band > 0.0)) return 0;
  return std::min(static_cast<int>(band), static_cast<int>(bands_.size()) - 1);
}

bool InsideTest::is_inside(const Vec3& point) const
{
  bool inside = false;
  for (const int n : bands_[band_of(point.z())])
    cut_facet(facet_[n], position_, point.z(), [&](const Vec3& a, const Vec3& b) {
      if ((a.y() > point.y()) == (b.y() > point.y())) return;
      const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > point.x()) inside = !inside;
    });
  return inside;
}

}  // namespace encased_column
