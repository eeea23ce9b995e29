// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <array>

namespace encased_column {

/// How a force at a point on or over a facet reaches its nodes, and how the facet moves there.
///
/// Area coordinates of the point's foot share out the force. The remaining moment (one that comes
/// with the force, and that of the point's height over the facet) becomes forces a x (x_i - c)
/// about the facet's centre c, the smallest that will do: (sum |r|^2 I - r r^T) a = moment, with
/// r = x_i - c. Forces only: a sleeve without bending stiffness could not take nodal moments, and
/// none resists a turn about the normal. Velocity and spin are the same map read backwards, so that
/// the power of the nodal forces is exactly force . velocity + moment . spin: else friction would
/// make energy.
class FacetLever {
 public:
  FacetLever(const std::array<Vec3, 3>& corner, const Vec3& point)
  {
    const Vec3 center = (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]);
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double square = normal.squaredNorm();
    for (int i = 0; i < 3; ++i) arm_[i] = corner[i] - center;
    const double spread = arm_[0].squaredNorm() + arm_[1].squaredNorm() + arm_[2].squaredNorm();
    // One division for all: the vector units take longest over those.
    across_ = 1.0 / (square * spread);
    const double by_square = across_ * spread;
    in_plane_ = 3.0 * by_square;
    height_ = point - center;
    for (int i = 0; i < 3; ++i) {
      const Vec3 side = corner[(i + 2) % 3] - corner[(i + 1) % 3];
      weight_(i) = 1.0 / 3.0 + by_square * normal.cross(side).dot(point - center);
      height_ -= weight_(i) * arm_[i];
    }
    normal_ = normal;
  }

  /// Nodal forces [N] whose sum is `force` and whose moment about any point is that of `force` [N]
  /// at the point plus `moment` [N m].
  std::array<Vec3, 3> nodal_forces(const Vec3& force, const Vec3& moment) const
  {
    const Vec3 turn = turn_by(moment + height_.cross(force));
    std::array<Vec3, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = weight_(i) * force + turn.cross(arm_[i]);
    return out;
  }

  /// Spin [rad/s] of the facet whose nodes move with `v` [m/s]: the least squares one.
  Vec3 spin(const std::array<Vec3, 3>& v) const
  {
    return turn_by(arm_[0].cross(v[0]) + arm_[1].cross(v[1]) + arm_[2].cross(v[2]));
  }

  /// Velocity [m/s] of the facet at the point, with that spin.
  Vec3 velocity(const std::array<Vec3, 3>& v, const Vec3& spin) const
  {
    return weight_(0) * v[0] + weight_(1) * v[1] + weight_(2) * v[2] + spin.cross(height_);
  }

 private:
  /// (sum |r|^2 I - r r^T)^-1 times a vector. In the facet's plane that matrix is the adjugate of
  /// S = sum r r^T, so its inverse is S / det S; the arms of a centroid make pairs of equal area,
  /// so that det S = 3 (2 A / 3)^2. Along the normal it is sum |r|^2.
  Vec3 turn_by(const Vec3& moment) const
  {
    Vec3 sum = (across_ * normal_.dot(moment)) * normal_;
    for (const Vec3& r : arm_) sum += (in_plane_ * r.dot(moment)) * r;
    return sum;
  }

  std::array<Vec3, 3> arm_;
  Vec3 weight_, height_;  ///< area coordinates of the foot; from the foot to the point [m]
  Vec3 normal_;           ///< of length 2 A [m^2]
  double in_plane_;       ///< 1 / det S [1/m^4]
  double across_;         ///< 1 / (4 A^2 sum |r|^2) [1/m^6]
};

}  // namespace encased_column
