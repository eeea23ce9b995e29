// SPDX-License-Identifier: GPL-2.0-only
#include "contact/contact_context.h"

#include "host/contact_law.h"
#include "host/find_fix.h"

#include <optional>

namespace encased_column {

void ContactContext::open(bool rolling)
{
  const auto modulus = read_pair_property(lmp_, "contactModulus", 0.0, true);
  const auto ratio = read_pair_property(lmp_, "stiffnessRatio", 0.0, true);
  const auto friction = read_pair_property(lmp_, "coefficientFriction", 0.0, false);
  const auto beta_n = read_pair_property(lmp_, "dampingRatioNormal", 0.0, false, 0.0);
  const auto beta_s = read_pair_property(lmp_, "dampingRatioShear", 0.0, false, 0.0);
  const std::optional<double> unless_given = rolling ? std::nullopt : std::optional<double>(0.0);
  const auto roll =
      read_pair_property(lmp_, "coefficientRollingFriction", 0.0, false, unless_given);

  stride_ = lmp_->atom->ntypes + 1;
  materials_.assign(stride_ * stride_, ContactMaterial());
  has_dashpots_ = false;
  for (int i = 1; i < stride_; ++i)
    for (int j = 1; j < stride_; ++j)
      materials_[i * stride_ + j] = {modulus.at(i, j), ratio.at(i, j),  friction.at(i, j),
                                     beta_n.at(i, j),  beta_s.at(i, j), roll.at(i, j)};

  for (const ContactMaterial& m : materials_)
    if (m.damping_normal > 0.0 || m.damping_shear > 0.0) has_dashpots_ = true;

  friction_of_deck_.clear();
  for (const ContactMaterial& m : materials_) friction_of_deck_.push_back(m.friction);
  friction_factor_ = 1.0;
  friction_factors_ = fixes_that_are<FrictionFactorOwner>(lmp_);

  const auto movers = fixes_that_are<MassScalingOwner>(lmp_);
  mass_scaling_ = movers.empty() ? nullptr : &movers.front()->mass_scaling;
  const auto timings = fixes_that_are<PairListTimingOwner>(lmp_);
  list_timing_ = timings.empty() ? nullptr : &timings.front()->list_timing;
  observers_ = fixes_that_are<ContactObserver>(lmp_);
  const auto accounts = fixes_that_are<ContactLossOwner>(lmp_);
  losses_ = accounts.empty() ? &no_account_ : &accounts.front()->contact_losses;
  asked_step_ = -1;
}

void ContactContext::ask_all_observers()
{
  asked_step_ = lmp_->update->ntimestep;
  active_.clear();
  for (ContactObserver* observer : observers_)
    if (observer->wants_contacts(asked_step_)) active_.push_back(observer);
  lower_friction();
}

// Friction that a packing needs changes at few steps: the others cost a comparison.
void ContactContext::lower_friction()
{
  double factor = 1.0;
  for (const FrictionFactorOwner* owner : friction_factors_) factor *= owner->friction_factor;
  if (factor == friction_factor_) return;
  friction_factor_ = factor;
  for (std::size_t n = 0; n < materials_.size(); ++n)
    materials_[n].friction = factor * friction_of_deck_[n];
}

void ContactContext::tell_observers(int i, int j, double share, const Touch& touch,
                                    const ContactAction& action)
{
  const double length = touch.i.radius + touch.j.radius - touch.overlap;
  const Contact contact{i,
                        j,
                        touch.normal,
                        action.force,
                        action.arm,
                        length,
                        action.stiffness.normal,
                        action.stiffness.shear,
                        action.stored,
                        share,
                        action.sliding,
                        kind_of(j)};
  for (ContactObserver* observer : active_) observer->add_contact(contact);
}

template <typename Batch>
void ContactContext::tell_observers(const Batch& batch)
{
  for (int n = 0; n < batch.count(); ++n) {
    const ContactStiffness k = batch.stiffness(n);
    const Contact contact{batch.i(n),
                          batch.j(n),
                          batch.normal(n),
                          batch.force(n),
                          batch.arm_i(n),
                          batch.distance(n),
                          k.normal,
                          k.shear,
                          batch.stored_energy(n),
                          batch.share(n),
                          batch.is_sliding(n),
                          kind_of(batch.j(n))};
    for (ContactObserver* observer : active_) observer->add_contact(contact);
  }
}

template void ContactContext::tell_observers(const ContactBatch&);
template void ContactContext::tell_observers(const RollingBatch&);

}  // namespace encased_column
