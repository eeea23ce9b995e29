// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

/// Sums of contact stiffness about one grain, per axis [N/m].
///
/// Translation feels k_n n_a^2 + k_t (1 - n_a^2); rotation feels k_t r^2 (1 - n_a^2) against an
/// inertia of 2/5 m r^2, which is kept here divided by r^2 * 2/5 so that both compare to the mass.
/// Source: Itasca PFC, "Time-step determination": directional stiffnesses without off-diagonals.
struct GrainStiffness {
  Vec3 translation = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();
  double wall = 0.0;  ///< the largest of the grain's contacts with walls, wall_stiffness()

  void add(const Vec3& normal, double normal_stiffness, double shear_stiffness)
  {
    const Vec3 along = normal.cwiseProduct(normal);
    const Vec3 across = Vec3::Ones() - along;
    translation += normal_stiffness * along + shear_stiffness * across;
    rotation += (shear_stiffness / 0.4) * across;
  }

  /// The stiffness [N/m] that the grain's mass must be set against.
  /// Rolling resistance is a second spring of at most k_t r^2 beside the rotation's: with it
  /// rotation counts twice.
  double decisive(bool rolling = false) const
  {
    return std::max({translation.maxCoeff(), (rolling ? 2.0 : 1.0) * rotation.maxCoeff(), wall});
  }
};

/// Stiffness [N/m] over k_n of a single contact that decides a grain's step: k_n along the normal
/// or k_t / 0.4 in rotation, twice that with rolling resistance.
inline double decisive_ratio(double stiffness_ratio, bool rolling)
{
  return std::max(1.0, (rolling ? 2.0 : 1.0) / (0.4 * stiffness_ratio));
}

/// Stiffness [N/m] that a contact with a wall asks the grain's mass to be set against, whatever its
/// direction; the sums per axis may ask less of an oblique one.
inline double wall_stiffness(double normal_stiffness, double shear_stiffness, bool rolling)
{
  return normal_stiffness * decisive_ratio(normal_stiffness / shear_stiffness, rolling);
}

/// Stable step [s] of a mass [kg] on a stiffness [N/m]: f sqrt(m/k).
///
/// A chain of equal grains has omega^2 <= 2 k / m with k the sum over its contacts, and central
/// differences are stable up to 2/omega = sqrt(2 m/k): f up to 1 leaves a reserve.
inline double stable_step(double mass, double stiffness, double safety)
{
  return safety * std::sqrt(mass / stiffness);
}

/// Mass [kg] whose stable step is `dt`: the inverse of stable_step().
inline double mass_for_step(double dt, double stiffness, double safety)
{
  return stiffness * (dt / safety) * (dt / safety);
}

}  // namespace encased_column
