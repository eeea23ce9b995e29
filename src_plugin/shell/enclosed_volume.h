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

/// Adds to `swept` (one per node) the volume [m^3] that each node sweeps along the normals of
/// facets [first, last) while all nodes go straight from `from` to `to`:
///
///   share_i = u_i / 3 . integral of the facet's area vector over the way.
///
/// The sum over nodes is the volume the surface sweeps, exactly: the area vector is quadratic along
/// the way. Where the borders stay or slide in their level planes it is the change of the enclosed
/// volume.
inline void add_swept_volume(const std::vector<Facet>& facet, const std::vector<Vec3>& from,
                             const std::vector<Vec3>& to, int first, int last,
                             std::vector<double>& swept)
{
  for (int f = first; f < last; ++f) {
    const auto [i, j, k] = facet[f];
    const Vec3 side = from[j] - from[i], other = from[k] - from[i];
    const Vec3 side_change = to[j] - to[i] - side, other_change = to[k] - to[i] - other;
    const Vec3 area =
        0.5 * (side.cross(other) + 0.5 * (side.cross(other_change) + side_change.cross(other)) +
               side_change.cross(other_change) / 3.0);
    for (const int node : facet[f]) swept[node] += (to[node] - from[node]).dot(area) / 3.0;
  }
}

}  // namespace encased_column
