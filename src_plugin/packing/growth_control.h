// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <array>

namespace encased_column {

/// What a growth that minds the stress looks at.
struct PackingState {
  double mean_stress = 0.0;       ///< of the specimen, positive in compression [Pa]
  double bulk_stiffness = 0.0;    ///< of its contacts, see ContactSums [Pa]
  double unbalanced_ratio = 1.0;  ///< mean unbalanced over mean contact force [-]
};

/// Sums over the contacts of a specimen for PackingState.
struct ContactSums {
  double virial = 0.0;     ///< of normal force times length [J]
  double stiffness = 0.0;  ///< of normal stiffness times length squared [J]

  /// A contact that presses with `normal_force` [N] across `length` [m], from center to center or
  /// to the wall; `share` as the rank counts it.
  void add(double share, double normal_force, double normal_stiffness, double length)
  {
    virial += share * normal_force * length;
    stiffness += share * normal_stiffness * length * length;
  }
  /// Love-Weber's mean stress, a third of the trace; shear forces have no part in it.
  double mean_stress(double volume) const { return virial / (3.0 * volume); }
  /// Rise of the mean stress over the volume strain when all grains grow alike and none gives way:
  /// a length l then grows by l / 3 of the strain. The stiffest answer there is.
  double bulk_stiffness(double volume) const { return stiffness / (9.0 * volume); }
};

/// Where growth is to end.
struct GrowthGoal {
  enum class Until {
    full_size,  ///< at full size, with the stress met
    limits,     ///< at the densest packing: all friction goes at once where grains first bear it
  };
  double stress = 5e3;           ///< mean stress that friction gives way to [Pa]
  double friction_ratio = 0.95;  ///< friction after over before one lowering [-]
  double rest = 1e-2;            ///< unbalanced force ratio at which grains are at rest [-]
  Until until = Until::full_size;
};

/// Growth of grains to full size under a stress: radius expansion with friction decrease.
///
/// Grains grow while the mean stress is below its target. Where they bear it, friction is lowered
/// by a small part and growth waits until they have given way. So the packing at full size has the
/// porosity that was drawn and no more stress than the target. Friction never rises.
///
/// Source: Chareyre, Briancon and Villard (2002), Geosynthetics International 9, 97-123; YADE's
/// tutorial of the triaxial test, which lowers friction by 5 % a time, as here. There, a bounded
/// multiplier of the radii follows the stress; here, the servo law of a wall: the strain that
/// closes a part of the gap by the stiffness of the contacts.
class GrowthControl {
 public:
  enum class Stage {
    grows,
    ended,      ///< the goal is met
    too_dense,  ///< frictionless and pressed before full size: the porosity is out of reach
    too_loose,  ///< at full size with all friction, and the grains bear nothing: likewise
    restless,   ///< pressed for long, and not at rest
  };

  /// From `start`, radius over full radius; no step is larger than one of `stages` equal parts of
  /// the volume.
  GrowthControl(const GrowthGoal& goal, double start, long stages);

  /// One look at the packing, and what follows.
  void decide(const PackingState& state);

  Stage stage() const { return stage_; }
  double radius_factor() const;                         ///< radius over full radius [-]
  double friction_factor() const { return friction_; }  ///< over the friction of the deck [-]
  /// Solid volume over that at full size [-]: now, where friction was lowered first, and where
  /// there was none and the grains bore the stress; 0 where that was not yet.
  double solid() const { return solid_; }
  double loosest() const { return loosest_; }
  double densest() const { return densest_; }

  /// All there is to know of it, for a restart file.
  static constexpr int numbers = 7;
  std::array<double, numbers> state() const;
  void restore(const std::array<double, numbers>& state);

 private:
  bool finds_limits() const { return goal_.until == GrowthGoal::Until::limits; }
  double target() const;  ///< stress that is pressed with [Pa]
  void note_densest(const PackingState& state);
  void grow(const PackingState& state);
  void lower_friction();
  void come_to_rest(bool at_rest, double pressed);
  void wait(Stage in_vain, double patience);

  GrowthGoal goal_;
  double largest_step_;
  double solid_;
  double friction_ = 1.0;
  double loosest_ = 0.0, densest_ = 0.0;
  double even_step_ = 0.0;  ///< of the volume, with which the grains have given way so far
  double waited_ = 0.0;     ///< looks in a row at which nothing was changed
  Stage stage_ = Stage::grows;
};

}  // namespace encased_column
