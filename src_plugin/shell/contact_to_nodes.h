#pragma once

#include "core/vec3.h"

#include <array>

#include <Eigen/Cholesky>

namespace encased_column {

/// The three nodal forces [N] that equal `force` [N] at `point` [m] together with `moment` [N m]:
/// their sum is the force, their moment about any point is that of the force plus `moment`.
///
/// Area coordinates of the point's foot share out the force. The remaining moment (from `moment`
/// and from the point's height over the facet) becomes forces a x (x_i - c) about the facet's
/// centre c, the smallest that will do: (sum |r|^2 I - r r^T) a = moment. Forces only: a sleeve
/// without bending stiffness could not take nodal moments, and none resists a turn about the
/// normal.
inline std::array<Vec3, 3> contact_to_nodes(const std::array<Vec3, 3>& corner, const Vec3& point,
                                            const Vec3& force, const Vec3& moment)
{
  const Vec3 center = (corner[0] + corner[1] + corner[2]) / 3.0;
  const std::array<Vec3, 3> arm{corner[0] - center, corner[1] - center, corner[2] - center};
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const double square = normal.squaredNorm();

  std::array<Vec3, 3> out;
  Vec3 rest = moment + (point - center).cross(force);
  Mat3 spread = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 side = corner[(i + 2) % 3] - corner[(i + 1) % 3];
    const double weight = 1.0 / 3.0 + normal.cross(side).dot(point - center) / square;
    out[i] = weight * force;
    rest -= arm[i].cross(out[i]);
    spread += arm[i].squaredNorm() * Mat3::Identity() - arm[i] * arm[i].transpose();
  }
  const Vec3 turn = spread.llt().solve(rest);
  for (int i = 0; i < 3; ++i) out[i] += turn.cross(arm[i]);
  return out;
}

}  // namespace encased_column
