// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

using Quaternion = Eigen::Quaterniond;

/// Rotation by |v| [rad] about the axis v.
inline Quaternion rotation_from_vector(const Vec3& v)
{
  const double square = v.squaredNorm();
  double cosine_half, sine_half_over_angle;
  if (square < 1e-2) {
    // Nodes turn by far less than 0.1 rad in a step: the series is exact to round-off and cheaper.
    const double q = 0.25 * square;
    cosine_half = 1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0)));
    sine_half_over_angle = 0.5 * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0)));
  } else {
    const double angle = std::sqrt(square);
    cosine_half = std::cos(0.5 * angle);
    sine_half_over_angle = std::sin(0.5 * angle) / angle;
  }
  const Vec3 imaginary = sine_half_over_angle * v;
  return {cosine_half, imaginary.x(), imaginary.y(), imaginary.z()};
}

/// The shortest rotation vector [rad] of a unit quaternion.
inline Vec3 rotation_vector(const Quaternion& q)
{
  const double sine = q.vec().norm();
  if (sine == 0.0) return Vec3::Zero();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return sign * 2.0 * std::atan2(sine, std::abs(q.w())) / sine * q.vec();
}

/// `q` after turning with the angular velocity `spin` [rad/s] for `dt` [s]; renormalised, so that
/// round-off does not grow with the number of steps.
inline Quaternion turned(const Quaternion& q, const Vec3& spin, double dt)
{
  return (rotation_from_vector(dt * spin) * q).normalized();
}

}  // namespace encased_column
