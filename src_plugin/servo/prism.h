#pragma once

#include "core/vec3.h"

namespace encased_column {

/// What a triangle of a mantle about the z axis adds to the volume inside it and to the mantle's
/// height-times-radius^2 [m^3]; `center` is a point of the axis. Triangles may be wound either way.
///
/// Divergence theorem with the field (x, y, 0)/2: V = 1/2 sum of |n . (x - c)| A over the mantle,
/// with the triangle's own mid point, exact for flat facets.
inline double mantle_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& center)
{
  const Vec3 area = 0.5 * (b - a).cross(c - a);
  Vec3 arm = (a + b + c) / 3.0 - center;
  arm.z() = 0.0;
  return 0.5 * std::abs(area.dot(arm));
}

}  // namespace encased_column
