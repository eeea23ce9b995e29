// SPDX-License-Identifier: GPL-2.0-only
// What tests of the sleeve hold and look at, and no run needs.
#pragma once

#include "shell/shell_model.h"

namespace encased_column {

/// Held along the unit vector `direction` only.
inline Support held_along(int node, const Vec3& direction)
{
  Support support{node};
  support.held = direction * direction.transpose();
  return support;
}

/// Mirror symmetry: a node in the plane with the unit `normal` stays in it and turns about the
/// normal only.
inline Support in_symmetry_plane(int node, const Vec3& normal)
{
  Support support = held_along(node, normal);
  support.held_rotation = Mat3::Identity() - support.held;
  return support;
}

inline Vec3 linear_momentum(const ShellModel& model)
{
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < model.nodes(); ++i) sum += model.mass()[i] * model.velocity()[i];
  return sum;
}

/// About the origin [N m s]; conserved by the integrator where no support and no load acts.
inline Vec3 angular_momentum(const ShellModel& model)
{
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < model.nodes(); ++i)
    sum += model.mass()[i] * model.position()[i].cross(model.velocity()[i]) +
           model.inertia()[i] * model.angular_velocity()[i];
  return sum;
}

}  // namespace encased_column
