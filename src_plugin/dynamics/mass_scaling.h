// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "dynamics/stable_step.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace encased_column {

/// Part of its velocity that a body keeps when its inertia (mass or moment of inertia) changes.
///
/// No force acts on the body. Mass that it takes on was at rest: the momentum stays. Mass that it
/// gives off goes on at the speed it had: the velocity stays. Energy leaves the motion both times.
/// The other two rules would make it out of nothing: (m' - m) v^2 / 2 at a kept velocity where
/// m' > m, and p^2 / 2 (1/m' - 1/m) at a kept momentum where m' < m.
inline double part_of_velocity(double inertia_before, double inertia)
{
  return inertia > inertia_before ? inertia_before / inertia : 1.0;
}

/// Gives a body the `inertia` `wanted`, and returns the kinetic energy [J] that this takes out.
inline double change_inertia(double& inertia, double wanted, Vec3& velocity)
{
  const double before = inertia * velocity.squaredNorm();
  velocity *= part_of_velocity(inertia, wanted);
  inertia = wanted;
  return 0.5 * (before - inertia * velocity.squaredNorm());
}

/// Grains in the arrays of the fix that moves them: triples of each vector, one number of each
/// scalar.
struct MovingGrains {
  double* velocity = nullptr;      ///< [m/s]
  double* spin = nullptr;          ///< [rad/s]
  const double* radius = nullptr;  ///< [m]
  const double* mass = nullptr;    ///< true mass [kg]
  int count = 0;
};

/// How heavy grains move. Without density scaling (`step` 0) that is their true mass; with it each
/// grain is heavy enough for its contacts at the step set.
///
/// Every change of mass goes through here, by the rule of change_inertia(), and its energy is
/// booked. In the middle of a step a grain has gone its way at the velocity of the half step, and
/// the work of the force on that way is still to come with the last half kick: a mass that grows
/// there counts in that kick, and the momentum is put right after it. So the account of a linear
/// spring closes to round-off; to slow the grain before the kick would lose force times way.
class MassScaling {
 public:
  /// What masses are found with, apart from the contacts.
  struct Rule {
    double step = 0.0;    ///< with density scaling: the step [s]; 0 without
    double safety = 0.8;  ///< fraction of the step sqrt(m/k) [-]
    /// Stiffness of one contact with something flat over pi times the radius [Pa], of the materials
    /// that ask for the smallest step.
    double stiffest_material = 0.0;
    bool rolling = false;  ///< contacts resist rolling
    bool scales() const { return step > 0.0; }
    bool operator==(const Rule& other) const;
  };

  Rule rule;

  double inertial_mass(int i) const { return inertia_[i]; }  ///< [kg]
  /// One a grain [kg]; zero where none was found yet.
  std::vector<double>& inertial_masses() { return inertia_; }
  const std::vector<double>& inertial_masses() const { return inertia_; }

  /// The grains of a step, or of a set-up, whose velocities are complete and which have not moved
  /// since.
  void begin_step(const MovingGrains& grains, bool way_was_gone);
  /// Grains without an inertial mass get that which one contact asks for. They come at the speed
  /// that the deck gave them with this mass: nothing is booked.
  void admit_new_grains();

  /// Before the contacts of the grains are added up.
  void clear_contacts();
  /// Contact of grain i with grain j, or with a wall (`j` < 0). Ghosts bring no grain's own mass.
  void add_contact(int i, int j, const Vec3& normal, double normal_stiffness,
                   double shear_stiffness);
  /// Grain i touches a wall by springs [N/m], which may be far stiffer than the grains': the code
  /// that finds the contact calls this at once, and the mass is raised where the step asks for it.
  void raise_mass_for_contact(int i, double normal_stiffness, double shear_stiffness)
  {
    if (!rule.scales()) return;
    const double needed = mass_for_step(
        rule.step, wall_stiffness(normal_stiffness, shear_stiffness, rule.rolling), rule.safety);
    if (needed > inertia_[i]) change_mass(i, needed);
  }
  /// Gives all grains the masses their contacts ask for, larger or smaller.
  struct Found {
    double stable_step, largest_factor;  ///< [s], inertial over true mass [-]
  };
  Found set_masses();

  /// In order of the grains from here on, before settle().
  void sort_raised();
  /// True where a grain before `end` that is not settled got heavier in this step.
  bool raised_before(int end) const
  {
    return settled_ < raised_.size() && raised_[settled_].grain < end;
  }
  /// After the last half kick of the grains before `end`: puts the momentum of those right that got
  /// heavier in the step.
  void settle(int end = std::numeric_limits<int>::max());

  /// Kinetic energy [J] that changes of mass took out since this was asked last.
  double take_loss();

 private:
  /// A grain that took on a mass [kg] at rest while it moved at these velocities.
  struct Raised {
    int grain;
    double added;
    Vec3 velocity, spin;
  };

  void change_mass(int i, double wanted);
  /// Stiffness [N/m] of one contact of grain i with something flat.
  double one_contact(int i) const;
  /// Stiffness [N/m] that decides on grain i's mass.
  double decisive_stiffness(int i) const;
  double mass_for(int i, double stiffness) const;
  double kinetic_energy_of(int i) const;

  MovingGrains grains_;
  bool way_was_gone_ = false;
  std::vector<double> inertia_;
  std::vector<GrainStiffness> stiffness_;  ///< empty until there is a contact
  std::vector<Raised> raised_;
  std::size_t settled_ = 0;  ///< of them
  double loss_ = 0.0;
};

/// A fix that decides how heavy grains move.
class MassScalingOwner {
 public:
  MassScaling mass_scaling;

 protected:
  virtual ~MassScalingOwner() = default;
};

}  // namespace encased_column
