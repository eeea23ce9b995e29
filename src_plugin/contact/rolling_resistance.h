// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/linear_law.h"

namespace encased_column {

/// Radius [m] that turns a normal force into a rolling resistance: r_i r_j / (r_i + r_j) between
/// grains, the grain's radius against a wall.
inline double rolling_radius(double r_i, double r_j)
{
  return r_i * r_j / (r_i + r_j);
}

/// Largest rolling torque [N m] of a contact; `dt` = 0 as in slider_slack().
inline double rolling_limit(double friction, double normal_force, double r, double dt)
{
  return friction * normal_force * r * slider_slack(dt > 0.0);
}

/// A contact's rolling torque one step on, before its slider has acted.
struct RollingTrial {
  Vec3 torque;    ///< [N m]
  double square;  ///< of its length [N2 m2]
  double from;    ///< its product with the torque it came from [N2 m2]

  /// With the `limit` mu_r F_n r [N m].
  bool slides(double limit) const { return square > limit * limit; }
  /// Of a torque that slides: the part that stays.
  double part(double limit) const { return limit / std::sqrt(square); }
  /// Energy the slider takes where it leaves `part` of the torque of a spring [J].
  double loss(double part, double stiffness) const
  {
    return 0.5 * (1.0 - part) * (from + part * square) / stiffness;
  }
};

/// The torque [N m] of the rolling spring `stiffness` [N m], moved on by the step `dt` [s]. `spin`
/// [rad/s] is w_i - w_j; its part along the normal `n` (twist) is not resisted. The torque is laid
/// into the contact plane and turns with the contact about the normal, by `half` before and by
/// `half` after it is advanced; with `dt` = 0 it stays as it is.
inline RollingTrial try_rolling(double stiffness, const Vec3& spin, const Turn& half, const Vec3& n,
                                double dt, const Vec3& torque)
{
  const double moves = dt > 0.0 ? 1.0 : 0.0;
  const Vec3 before = half.of(laid_into_plane(torque, n, moves), n);
  const Vec3 trial = before + stiffness * dt * (spin - spin.dot(n) * n);
  return {half.of(trial, n), trial.squaredNorm(), before.dot(trial)};
}

/// Elastic-plastic rolling resistance without viscous part, the host's `epsd2`: advances the
/// torque [N m] that resists the rolling of i on j and returns the energy the plastic part took in
/// this step [J].
///
/// Spring k_r = k_t r^2, limit mu_r F_n r, both with r = rolling_radius(); the rest as in
/// try_rolling().
/// Source: Ai, Chen, Rotter, Ooi (2011), Powder Technology 206, 269-282, model C; Iwashita and Oda
/// (1998), J. Eng. Mech. 124, 285-292, for the spring.
inline double advance_rolling_torque(double shear_stiffness, double friction, double r,
                                     double normal_force, const Vec3& spin, const Turn& half,
                                     const Vec3& n, double dt, Vec3& torque)
{
  const double stiffness = shear_stiffness * r * r;
  const double limit = rolling_limit(friction, normal_force, r, dt);
  const RollingTrial trial = try_rolling(stiffness, spin, half, n, dt, torque);
  const double part = trial.slides(limit) ? trial.part(limit) : 1.0;
  torque = part * trial.torque;
  return trial.loss(part, stiffness);
}

/// Energy [J] in the rolling spring.
inline double rolling_energy(double shear_stiffness, double r, const Vec3& torque)
{
  return 0.5 * torque.squaredNorm() / (shear_stiffness * r * r);
}

}  // namespace encased_column
