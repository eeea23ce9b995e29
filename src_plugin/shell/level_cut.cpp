// SPDX-License-Identifier: GPL-2.0-only
#include "shell/level_cut.h"

namespace encased_column {

// Towards an open end a ray may pass above the surface: no core there.
InsideTest::InsideTest(const std::vector<Facet>& facet, const std::vector<Vec3>& position)
    : facet_(facet),
      position_(position),
      bands_(facet, position),
      has_core_(bands_.size(), false)
{
  for (int b = 1; b + 1 < bands_.size(); ++b) {
    bool inside = bands_.is_in_free_middle(bands_.middle(b), b);
    for (const double part : {0.01, 0.5, 0.99}) {
      Vec3 point = bands_.middle(b);
      point.z() = bands_.height_in(b, part);
      inside = inside && is_inside(point, b);
    }
    has_core_[b] = inside;
  }
}

bool InsideTest::is_inside(const Vec3& point) const
{
  const int band = bands_.band_of(point.z());
  return (has_core_[band] && bands_.is_in_free_middle(point, band)) || is_inside(point, band);
}

/// True where no piece of the facet crosses the plane at `y` [m]: most facets of a band.
bool InsideTest::is_beside(const Facet& f, double y) const
{
  const bool above = position_[f[0]].y() > y;
  return above == (position_[f[1]].y() > y) && above == (position_[f[2]].y() > y);
}

bool InsideTest::is_inside(const Vec3& point, int band) const
{
  bool inside = false;
  for (const int n : bands_.facets(band)) {
    if (is_beside(facet_[n], point.y())) continue;
    cut_facet(facet_[n], position_, point.z(), [&](const Vec3& a, const Vec3& b) {
      if ((a.y() > point.y()) == (b.y() > point.y())) return;
      const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > point.x()) inside = !inside;
    });
  }
  return inside;
}

}  // namespace encased_column
