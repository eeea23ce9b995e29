// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/turning_spring.h"
#include "core/constants.h"
#include "core/vec3.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

/// Micro-parameters of one pair of materials.
struct ContactMaterial {
  double modulus = 0.0;           ///< E* [Pa]
  double stiffness_ratio = 1.0;   ///< kappa* = k_n / k_t [-]
  double friction = 0.0;          ///< mu [-]
  double damping_normal = 0.0;    ///< beta_n [-], fraction of critical
  double damping_shear = 0.0;     ///< beta_s [-]
  double rolling_friction = 0.0;  ///< mu_r [-]
};

/// Springs of a contact [N/m].
struct ContactStiffness {
  double normal;
  double shear;
};

/// Stiffness k_n = A E* / L, k_t = k_n / kappa*, A = pi r^2 of a contact of which the smaller
/// radius is `r` [m] and the distance of the centers at first touch is `length` [m]; against a wall
/// both are the grain's radius. Source: Itasca PFC, linear model, "deformability" method.
inline ContactStiffness linear_stiffness(const ContactMaterial& m, double r, double length)
{
  const double normal = pi * r * r * m.modulus / length;
  return {normal, normal / m.stiffness_ratio};
}

/// Motion of body i as seen from body j at their contact [m/s].
struct ContactVelocity {
  double closing;  ///< positive while the bodies approach
  Vec3 slip;       ///< in the contact plane
  /// With which the contact turns about its normal [rad/s]: the mean of the bodies' spins.
  double twist = 0.0;
};

/// Relative velocity of two bodies with velocities `v` [m/s], spins `w` [rad/s] and lever arms `c`
/// [m] from center to contact; `n` is the unit normal from i to j.
inline ContactVelocity contact_velocity(const Vec3& n, const Vec3& v_i, const Vec3& w_i, double c_i,
                                        const Vec3& v_j, const Vec3& w_j, double c_j)
{
  const Vec3 relative = v_i - v_j;
  const double closing = relative.dot(n);
  return {closing, relative - closing * n + (c_i * w_i + c_j * w_j).cross(n),
          0.5 * (w_i + w_j).dot(n)};
}

/// Mass [kg] with which two grains meet.
inline double effective_mass(double m_i, double m_j)
{
  return m_i * m_j / (m_i + m_j);
}

/// Dashpot [N s/m] of the fraction `beta` of critical damping; no square root where there is none.
inline double dashpot(double beta, double mass, double stiffness)
{
  return beta > 0.0 ? 2.0 * beta * std::sqrt(mass * stiffness) : 0.0;
}

/// Force between two bodies at a contact.
struct ContactForce {
  double normal;         ///< pressing the bodies apart, never tensile [N]
  Vec3 shear;            ///< on body i [N]
  bool sliding;          ///< Coulomb's limit is reached
  double friction_loss;  ///< work of the slider in this step [J]
  double dashpot_loss;   ///< work of both dashpots in this step [J]
};

/// Factor [-] on the limit of a slider: one that was left at its limit must not be beyond it by
/// round-off when its force is only repeated.
inline double slider_slack(bool advance)
{
  return advance ? 1.0 : 1.0 + 1e-12;
}

/// Linear contact: springs, dashpots 2 beta sqrt(m k) and Coulomb's slider on the shear spring.
///
/// `spring` [m] is the elongation of the shear spring; with `advance` it is laid into the contact
/// plane, turned with the contact about the normal, stretched in the middle of that turn by the
/// slip of the step `dt` [s], and shortened where the contact slides. Without, the forces are those
/// of the last step, to the last bit. `overlap` > 0 [m], `mass` [kg] effective mass of the pair,
/// `n` the unit normal (either sense). The loss of the slider is the mean of the shear force before
/// and after, times the slip the spring gave up, all in the middle of the turn: with it the
/// trapezoidal work of the contact force that turns along is exactly stored + lost. Source: Itasca
/// PFC, linear model; Cundall and Strack (1979), Geotechnique 29, 47-65. contact_batch.cpp has the
/// same law written out for vector units, and says what one template for both would cost.
[[gnu::always_inline]] inline ContactForce linear_contact(const ContactMaterial& m,
                                                          const ContactStiffness& k, double overlap,
                                                          double mass, const ContactVelocity& v,
                                                          const Vec3& n, double dt, bool advance,
                                                          Vec3& spring)
{
  const double c_normal = dashpot(m.damping_normal, mass, k.normal);
  const double elastic = k.normal * overlap;
  const double normal = std::max(0.0, elastic + c_normal * v.closing);

  Turn half;
  Vec3 before = spring;
  if (advance) {
    half = half_turn(v.twist * dt);
    before = half.of(laid_into_plane(spring, n), n);
  }
  Vec3 trial = before;
  if (advance) trial += v.slip * dt;

  const double limit = m.friction * normal * slider_slack(advance);
  const double length = trial.norm();
  ContactForce force{normal, Vec3::Zero(), k.shear * length > limit, 0.0, 0.0};
  const Vec3 kept = force.sliding ? Vec3(trial * (limit / (k.shear * length))) : trial;
  const Vec3 turned = half.of(kept, n);
  force.shear = -k.shear * turned;
  if (force.sliding) {
    if (advance) force.friction_loss = 0.5 * k.shear * (before + kept).dot(trial - kept);
  } else {
    const double c_shear = dashpot(m.damping_shear, mass, k.shear);
    force.shear -= c_shear * v.slip;
    if (advance) force.dashpot_loss = c_shear * v.slip.squaredNorm() * dt;
  }
  if (advance) {
    force.dashpot_loss += (normal - elastic) * v.closing * dt;
    spring = turned;
  }
  return force;
}

/// Energy [J] in the springs of a contact.
inline double spring_energy(const ContactStiffness& k, double overlap, const Vec3& spring)
{
  return 0.5 * (k.normal * overlap * overlap + k.shear * spring.squaredNorm());
}

}  // namespace encased_column
