#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

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

}  // namespace encased_column
