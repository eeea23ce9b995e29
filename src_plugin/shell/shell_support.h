// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

namespace encased_column {

/// What holds a node of the sleeve. Along the directions that `held` projects on, the node moves
/// with `velocity`; about those of `held_rotation` it turns with `angular_velocity`; it is free in
/// all others.
struct Support {
  int node;
  Mat3 held = Mat3::Zero();              ///< projector, symmetric
  Mat3 held_rotation = Mat3::Zero();     ///< projector, symmetric
  Vec3 velocity = Vec3::Zero();          ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
  Vec3 force = Vec3::Zero();   ///< found in the last step: on the sleeve, by the support [N]
  Vec3 moment = Vec3::Zero();  ///< [N m]
};

/// All translations held, or moved with `velocity` [m/s]; rotations free.
inline Support held(int node, const Vec3& velocity = Vec3::Zero())
{
  Support support{node};
  support.held = Mat3::Identity();
  support.velocity = velocity;
  return support;
}

/// Translations and rotations held, or moved with `velocity` [m/s].
inline Support clamped(int node, const Vec3& velocity = Vec3::Zero())
{
  Support support = held(node, velocity);
  support.held_rotation = Mat3::Identity();
  return support;
}

/// Held across the unit vector `axis`, free along it: an end diaphragm, or a sleeve that cannot
/// leave the rim of a platen but slides on it.
inline Support held_across(int node, const Vec3& axis)
{
  Support support{node};
  support.held = Mat3::Identity() - axis * axis.transpose();
  return support;
}

}  // namespace encased_column
