// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/pressure_load.h"

#include <vector>

namespace encased_column {

/// Volume [m^3] that facets [first, last) of a lateral surface enclose between the heights of the
/// window, positive with outward facets.
///
/// Gauss with the field (x, y, 0) / 2: level planes at the window's ends carry no flux, so the
/// lateral surface alone gives the volume, exactly for plane facets. The surface must cover the
/// whole window; above or below it nothing is counted.
inline double enclosed_volume(const std::vector<Facet>& facet, const std::vector<Vec3>& position,
                              int first, int last, const HeightWindow& window)
{
  double twice = 0.0;
  for (int f = first; f < last; ++f) {
    const Vec3 &a = position[facet[f][0]], &b = position[facet[f][1]], &c = position[facet[f][2]];
    const FacetPart part = part_in_window({a.z(), b.z(), c.z()}, window);
    if (part.share == 0.0) continue;
    const Vec3 area = area_vector(a, b, c);
    twice += area.x() * part.weight.dot(Vec3(a.x(), b.x(), c.x())) +
             area.y() * part.weight.dot(Vec3(a.y(), b.y(), c.y()));
  }
  return 0.5 * twice;
}

}  // namespace encased_column
