// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

// What a contact keeps in its plane, the shear spring and the rolling torque, goes along with the
// plane: as the normal turns, and as the bodies turn about the normal. Left where it was it would
// get a part along the normal, and a rolling torque with such a part drives the twist of the bodies
// without an end: nothing resists twist, and no spring is relaxed by it. Choices are by value, for
// the vector units.

/// Largest length a vector laid into a turned plane is stretched to, over that of its projection
/// [-]: a plane that turns by more than 60 degrees in a step only shortens it.
constexpr double longest_stretch = 2.0;

/// Added to squares of lengths, so that nothing is divided by zero.
constexpr double no_square = 1e-200;

/// The `vector` of the plane across the last normal, laid into the plane across `n`: projected and
/// brought back to its length, which is the smallest turn that does it. Over many small turns of
/// the normal this is parallel transport; one turn by the angle a is followed to a^2 / 4.
/// With `moves` = 0 instead of 1 it stays as it is to the last bit.
/// Source: Luding (2008), Granular Matter 10, 235-246, on the tangential spring.
inline Vec3 laid_into_plane(const Vec3& vector, const Vec3& n, double moves = 1.0)
{
  const double along = moves * vector.dot(n);
  const double square = vector.squaredNorm() + no_square;
  const double left = square - along * along;
  const double least = square / (longest_stretch * longest_stretch);
  return std::sqrt(square / (left > least ? left : least)) * (vector - along * n);
}

/// A turn about the normal.
struct Turn {
  double cosine = 1.0, sine = 0.0;

  /// What of `vector`, across `n`, the turn makes; its length stays.
  Vec3 of(const Vec3& vector, const Vec3& n) const
  {
    return cosine * vector + sine * n.cross(vector);
  }
};

/// Largest tangent of a fourth of an angle that half_turn() follows [-]: 1.85 rad a step. What
/// turns faster cannot be followed in such steps, and a longer half turn would make the spring of a
/// grain at the largest stable step grow.
constexpr double largest_quarter = 0.5;

/// Half of the turn by `angle` [rad]: Cayley's form of the rotation by a small angle, of which the
/// length is exact and the angle too small by angle^3 / 96.
///
/// A contact turns by half before the slip of the step is added and by half after it: the slip is
/// that of the middle of the step, and a spring that turns then neither gains nor loses energy
/// (turned as a whole before, it gains the part angle sqrt(k dt^2 / m) / 4 a step).
/// Source: Itasca PFC, linear model, for the turn with the mean spin about the normal.
inline Turn half_turn(double angle)
{
  const double below = 0.25 * angle < largest_quarter ? 0.25 * angle : largest_quarter;
  const double quarter = below > -largest_quarter ? below : -largest_quarter;
  const double scale = 1.0 / (1.0 + quarter * quarter);
  return {(1.0 - quarter * quarter) * scale, 2.0 * quarter * scale};
}

}  // namespace encased_column
