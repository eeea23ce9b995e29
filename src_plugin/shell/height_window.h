// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "specimen/platen.h"

#include <array>

namespace encased_column {

/// The part of a facet inside a window: share of its area, and the area coordinates of that part's
/// centroid, weighted with the share (they sum to it).
struct FacetPart {
  double share = 0.0;          ///< [-]
  Vec3 weight = Vec3::Zero();  ///< [-]
};

/// Cuts a facet of which the corners lie at heights `z` [m] against the window. The part grows
/// continuously as the window moves, so a platen that passes a facet makes no jump in the pressure.
inline FacetPart part_in_window(const Vec3& z, const HeightWindow& window)
{
  if (z.minCoeff() >= window.low && z.maxCoeff() <= window.high)
    return {1.0, Vec3::Constant(1.0 / 3.0)};
  if (z.maxCoeff() <= window.low || z.minCoeff() >= window.high) return {};

  // Sutherland and Hodgman, in area coordinates: at most two corners more than the facet.
  std::array<Vec3, 5> corner{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  int corners = 3;
  const auto keep_above = [&](const Vec3& height, double level) {
    std::array<Vec3, 5> kept;
    int count = 0;
    for (int i = 0; i < corners; ++i) {
      const Vec3 a = corner[i], b = corner[(i + 1) % corners];
      const double over_a = height.dot(a) - level, over_b = height.dot(b) - level;
      if (over_a >= 0.0) kept[count++] = a;
      if ((over_a > 0.0 && over_b < 0.0) || (over_a < 0.0 && over_b > 0.0))
        kept[count++] = a + over_a / (over_a - over_b) * (b - a);
    }
    corner = kept;
    corners = count;
  };
  if (z.minCoeff() < window.low) keep_above(z, window.low);
  if (z.maxCoeff() > window.high) keep_above(-z, -window.high);

  FacetPart part;
  for (int i = 1; i + 1 < corners; ++i) {
    // Area over the facet's: the triple product of area coordinates.
    const double share = corner[0].dot(corner[i].cross(corner[i + 1]));
    part.share += share;
    part.weight += share / 3.0 * (corner[0] + corner[i] + corner[i + 1]);
  }
  return part;
}

}  // namespace encased_column
