// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

using Quaternion = Eigen::Quaterniond;

/// Cosine of half an angle, and sine of it over the angle.
struct HalfAngle {
  double cosine, sine_over_angle;
};

/// Angles of which the square is less are small [rad^2]: nodes turn by far less than 0.1 rad in a
/// step.
constexpr double small_square = 1e-2;

/// Of a small angle, from its square: the series is exact to round-off.
inline HalfAngle half_of_small(double square)
{
  const double q = 0.25 * square;
  const double a = 1.0 / 12.0, b = 1.0 / 30.0, c = 1.0 / 56.0, d = 1.0 / 6.0, e = 1.0 / 42.0;
  return {1.0 - 0.5 * q * (1.0 - a * q * (1.0 - b * q * (1.0 - c * q))),
          0.5 - 0.5 * d * q * (1.0 - 0.05 * q * (1.0 - e * q))};
}

/// Rotation by |v| [rad] about the axis v.
inline Quaternion rotation_from_vector(const Vec3& v)
{
  const double square = v.squaredNorm(), angle = std::sqrt(square);
  const HalfAngle half = square < small_square
                             ? half_of_small(square)
                             : HalfAngle{std::cos(0.5 * angle), std::sin(0.5 * angle) / angle};
  const Vec3 imaginary = half.sine_over_angle * v;
  return {half.cosine, imaginary.x(), imaginary.y(), imaginary.z()};
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
