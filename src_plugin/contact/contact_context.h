// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/pair_list_timing.h"
#include "contact/rolling_batch.h"
#include "dynamics/mass_scaling.h"
#include "host/contact_observer.h"
#include "host/friction_factor.h"

#include <type_traits>
#include <vector>

namespace encased_column {

/// What pairs and walls share around the contact law: the materials the deck gave, the observers of
/// contacts, and the account of losses. One for each pair style, wall model and rigid wall.
/// Contacts are resolved in batches or one by one, not by turns, since sums of forces in another
/// order would not repeat a step to the last bit.
class ContactContext {
 public:
  /// `walls` says what stands where a contact has no second grain: a wall or a sleeve.
  explicit ContactContext(LAMMPS_NS::LAMMPS* lmp, ContactKind walls = ContactKind::wall)
      : lmp_(lmp),
        walls_(walls)
  {
  }

  /// At the start of a run: reads materials, finds observers and the account, and what lowers the
  /// friction. Throws InputError.
  void open(bool rolling);

  /// At the start of a force computation (cheap when asked again in the same step).
  void ask_observers()
  {
    if (asked_step_ != lmp_->update->ntimestep) ask_all_observers();
  }

  const ContactMaterial& material(int type_i, int type_j) const
  {
    return materials_[type_i * stride_ + type_j];
  }

  /// How far grains may be from where lists found them.
  GrainReach reach() const
  {
    return GrainReach(lmp_->neighbor->skin, list_timing_ ? list_timing_->account() : nullptr);
  }
  /// True where what is near the grains must be listed in this step, since they were themselves, or
  /// may go further than was known.
  bool needs_lists() const { return lmp_->neighbor->ago == 0 || reach().is_wider_here(); }

  /// False where no pair of types has a dashpot: the effective mass is not needed then.
  bool has_dashpots() const { return has_dashpots_; }

  /// Resolves the contacts of a batch, books their losses and tells the observers.
  template <typename Batch>
  void resolve(Batch& batch, bool advance)
  {
    const double step = static_cast<double>(lmp_->update->ntimestep);
    const double loss = batch.resolve(lmp_->update->dt, step, advance);
    if (!active_.empty()) tell_observers(batch);
    if (!advance) return;
    losses_->friction += loss;
    losses_->dashpots += batch.dashpot_loss();
    if constexpr (std::is_same_v<Batch, RollingBatch>) losses_->rolling += batch.rolling_loss();
    batch.keep(step);
  }

  /// Books the losses and tells the observers; `share` as in Contact, j = -1 for a wall.
  void book(int i, int j, double share, bool advance, const Touch& touch,
            const ContactAction& action)
  {
    if (advance) {
      losses_->friction += share * action.friction_loss;
      losses_->dashpots += share * action.dashpot_loss;
      losses_->rolling += share * action.rolling_loss;
    }
    if (!active_.empty()) tell_observers(i, j, share, touch, action);
  }

  /// Asks for what raise_mass_for_contact() needs. Inline: as it returns nothing, a call would be
  /// left out.
  [[gnu::always_inline]] void fetch_mass(int i) const
  {
    if (mass_scaling_) __builtin_prefetch(mass_scaling_->inertial_masses().data() + i, 0, 2);
  }
  /// Grain i touches a wall: its mass must allow for the contact's springs from this step on.
  void raise_mass_for_contact(int i, const ContactStiffness& k)
  {
    if (mass_scaling_) mass_scaling_->raise_mass_for_contact(i, k.normal, k.shear);
  }

 private:
  ContactKind kind_of(int j) const { return j < 0 ? walls_ : ContactKind::grain; }
  void ask_all_observers();
  void lower_friction();
  void tell_observers(int i, int j, double share, const Touch& touch, const ContactAction& action);
  template <typename Batch>
  void tell_observers(const Batch& batch);

  LAMMPS_NS::LAMMPS* lmp_;
  ContactKind walls_;
  int stride_ = 0;
  bool has_dashpots_ = false;
  std::vector<ContactMaterial> materials_;
  std::vector<double> friction_of_deck_;  ///< of the materials [-]
  std::vector<FrictionFactorOwner*> friction_factors_;
  double friction_factor_ = 1.0;  ///< that the materials have
  MassScaling* mass_scaling_ = nullptr;
  const PairListTiming* list_timing_ = nullptr;
  std::vector<ContactObserver*> observers_, active_;
  ContactLosses no_account_;
  ContactLosses* losses_ = &no_account_;
  LAMMPS_NS::bigint asked_step_ = -1;
};

}  // namespace encased_column
