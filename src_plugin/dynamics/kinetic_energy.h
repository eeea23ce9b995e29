#pragma once

#include "core/vec3.h"

namespace encased_column {

/// Kinetic energy [J] of a solid sphere of mass [kg], radius [m], velocity [m/s] and spin [rad/s].
inline double kinetic_energy(double mass, double radius, const Vec3& velocity, const Vec3& spin)
{
  return 0.5 * mass * (velocity.squaredNorm() + 0.4 * radius * radius * spin.squaredNorm());
}

}  // namespace encased_column
