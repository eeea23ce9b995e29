// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/linear_law.h"
#include "contact/rolling_resistance.h"

namespace encased_column {

/// One body at a contact.
struct ContactBody {
  double radius;  ///< [m], 0 for a wall
  Vec3 velocity;  ///< of its center, or of the wall at the contact [m/s]
  Vec3 spin;      ///< [rad/s]
};

/// Two bodies that overlap.
struct Touch {
  double overlap;  ///< larger than zero [m]
  Vec3 normal;     ///< unit, from i to j
  double mass;     ///< effective mass of the pair [kg]
  ContactBody i, j;
  bool is_wall() const { return j.radius == 0.0; }
};

/// Numbers a contact remembers: three of the shear spring [m], the step it was last seen, and, with
/// rolling resistance, three of the rolling torque [N m].
constexpr int memory_size = 4;
constexpr int memory_size_rolling = 7;

/// What a contact does to its bodies.
struct ContactAction {
  Vec3 force;     ///< on i, the opposite on j [N]
  Vec3 moment_i;  ///< [N m]
  Vec3 moment_j;  ///< [N m]
  double normal_force;
  ContactStiffness stiffness;
  double arm;                                        ///< from the center of i to the contact [m]
  double stored;                                     ///< spring energy [J]
  double friction_loss, dashpot_loss, rolling_loss;  ///< in this step [J]
  bool sliding;
};

/// From the center of a grain of radius `r` [m] to its contact [m]: half way into the overlap.
inline double contact_arm(double r, double overlap)
{
  return r - 0.5 * overlap;
}

/// Linear contact with history: stiffness from the radii, force, moments and losses. With `advance`
/// the memory moves on by the step `dt` [s] that ends at step number `step`.
///
/// A contact that was not there one step ago starts from zero, whatever the memory holds: the host
/// keeps the history of a pair that parts and meets again between two of its list builds.
template <bool rolling>
[[gnu::always_inline]] inline ContactAction resolve_contact(const ContactMaterial& material,
                                                            const Touch& t, double dt, double step,
                                                            bool advance, double* memory)
{
  const bool wall = t.is_wall();
  const double smaller = wall ? t.i.radius : std::min(t.i.radius, t.j.radius);
  const ContactStiffness k = linear_stiffness(material, smaller, t.i.radius + t.j.radius);
  const double arm_i = contact_arm(t.i.radius, t.overlap);
  const double arm_j = wall ? 0.0 : contact_arm(t.j.radius, t.overlap);

  const bool fresh = memory[3] < step - 1.0;
  if (advance) memory[3] = step;

  Eigen::Map<Vec3> kept_spring(memory);
  Vec3 spring = kept_spring;
  if (fresh) spring.setZero();
  const ContactVelocity velocity =
      contact_velocity(t.normal, t.i.velocity, t.i.spin, arm_i, t.j.velocity, t.j.spin, arm_j);
  const ContactForce f =
      linear_contact(material, k, t.overlap, t.mass, velocity, t.normal, dt, advance, spring);
  if (advance) kept_spring = spring;

  const Vec3 twist = t.normal.cross(f.shear);
  ContactAction action{f.shear - f.normal * t.normal,
                       arm_i * twist,
                       arm_j * twist,
                       f.normal,
                       k,
                       arm_i,
                       spring_energy(k, t.overlap, spring),
                       f.friction_loss,
                       f.dashpot_loss,
                       0.0,
                       f.sliding};
  if constexpr (rolling) {
    Eigen::Map<Vec3> kept_torque(memory + memory_size);
    Vec3 torque = kept_torque;
    if (fresh) torque.setZero();
    const double r = wall ? t.i.radius : rolling_radius(t.i.radius, t.j.radius);
    action.rolling_loss = advance_rolling_torque(
        k.shear, material.rolling_friction, r, f.normal, t.i.spin - t.j.spin,
        half_turn(advance ? velocity.twist * dt : 0.0), t.normal, advance ? dt : 0.0, torque);
    action.stored += rolling_energy(k.shear, r, torque);
    if (advance) kept_torque = torque;
    action.moment_i -= torque;
    action.moment_j += torque;
  }
  return action;
}

}  // namespace encased_column
