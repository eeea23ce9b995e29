// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "dynamics/unbalanced_force_ratio.h"
#include "files/column.h"
#include "measure/energy_account.h"
#include "measure/seen_contact.h"
#include "specimen/specimen.h"

#include <vector>

namespace encased_column {

/// A grain as the history of a specimen sees it.
struct SeenGrain {
  Vec3 x, v, omega;  ///< [m], [m/s], [rad/s]
  double radius;     ///< [m]
  double mass;       ///< that weighs [kg]
  double inertia;    ///< that moves [kg]
  int contacts;
};

/// What grains and contacts of a specimen add up to; the middle third of its height is the core,
/// away from what the platens do to the stress.
class SpecimenSums {
 public:
  /// Plain numbers, so that the sums of the ranks add up too.
  struct Numbers {
    double grains, solid, shared, inertia, diameter, weight_height, mass;
    double elastic, kinetic, friction, rolling, dashpots;
    double core_solid, core_axial, core_radial;  ///< [m^3], Love-Weber products [J]
    double ends, without_contact, with_one_contact;
  };

  /// Begins a sample of a specimen that fills `window` about `axis` [m].
  void start(const HeightWindow& window, const Vec3& axis);
  void add(const SeenContact& contact);
  void add(const SeenGrain& grain, const Vec3& gravity);

  Numbers& numbers() { return n_; }
  double* first() { return &n_.grains; }
  static constexpr std::size_t count = sizeof(Numbers) / sizeof(double);

 private:
  void add_to_core(const Vec3& x, const Vec3& lever, const Vec3& force);

  HeightWindow core_;
  Vec3 axis_ = Vec3::Zero();
  Numbers n_{};
};

/// What strains, works and losses are taken of; plain numbers, as a restart file keeps them.
struct SpecimenMoment {
  SpecimenState state;
  EnergyAccount energy;

  double* first() { return &state.height; }
  static constexpr std::size_t count =
      (sizeof(SpecimenState) + sizeof(EnergyAccount)) / sizeof(double);
};

/// All that one row of the history is made of.
struct SpecimenSample {
  double step;
  SpecimenMoment before, now;  ///< strains, works and losses count from the first
  SpecimenSums::Numbers sums;
  double strain_rate;  ///< axial [1/s]
  UnbalancedForceRatio unbalanced_ratio;
  double energy_error;  ///< [-]

  double mean_stress() const;  ///< [Pa]
  /// Stress [Pa] of the grains of the core from a sum of their Love-Weber products [J], spread over
  /// the room they take up with their share of the voids.
  double core_stress(double products) const;
};

/// The columns of a specimen's history, in their order.
const std::vector<Column<SpecimenSample>>& specimen_columns();

}  // namespace encased_column
