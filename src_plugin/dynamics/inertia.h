// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

/// Kinetic energy [J] of a solid sphere of mass [kg], radius [m], velocity [m/s] and spin [rad/s].
inline double kinetic_energy(double mass, double radius, const Vec3& velocity, const Vec3& spin)
{
  return 0.5 * mass * (velocity.squaredNorm() + 0.4 * radius * radius * spin.squaredNorm());
}

/// True where the force [N] on a grain is its weight but for round-off, 1e-10 of it: nothing
/// touches it. `gravity` [m/s^2].
inline bool feels_only_weight(const Vec3& force, double mass, const Vec3& gravity)
{
  return (force - mass * gravity).squaredNorm() <= 1e-20 * mass * mass * gravity.squaredNorm();
}

/// Slows `velocity` [m/s] down to the square `limit_square` of a speed below its own, and returns
/// the kinetic energy [J] that an inertial mass [kg] loses so.
inline double slow_down_to(double limit_square, double inertia, double* velocity)
{
  Eigen::Map<Vec3> v(velocity);
  const double square = v.squaredNorm();
  v *= std::sqrt(limit_square / square);
  return 0.5 * inertia * (square - limit_square);
}

/// Inertial number I = rate d sqrt(rho / p) [-]: below 1e-3 shear is quasi-static.
/// `rate` [1/s] of strain, `d` [m] grain size, `density` [kg/m^3] of the grains' inertial mass, `p`
/// [Pa] mean stress.
/// Source: GDR MiDi (2004), Eur. Phys. J. E 14, 341-365.
inline double inertial_number(double rate, double d, double density, double p)
{
  return std::abs(rate) * d * std::sqrt(density / p);
}

}  // namespace encased_column
