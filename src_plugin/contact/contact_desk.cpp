#include "contact/contact_desk.h"

#include "host/pair_property.h"

#include <optional>

namespace encased_column {

void ContactDesk::open(bool rolling)
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

  const auto movers = fixes_that_are<MassScalingOwner>(lmp_);
  mass_scaling_ = movers.empty() ? nullptr : &movers.front()->mass_scaling;
  probes_ = fixes_that_are<ContactProbe>(lmp_);
  const auto accounts = fixes_that_are<ContactLossOwner>(lmp_);
  losses_ = accounts.empty() ? &no_account_ : &accounts.front()->contact_losses;
  asked_step_ = -1;
}

void ContactDesk::ask_probes_anew()
{
  asked_step_ = lmp_->update->ntimestep;
  active_.clear();
  for (ContactProbe* probe : probes_)
    if (probe->wants_contacts(asked_step_)) active_.push_back(probe);
}

void ContactDesk::tell_probes(int i, int j, double share, const Touch& touch,
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
  for (ContactProbe* probe : active_) probe->add_contact(contact);
}

template <typename Row>
void ContactDesk::tell_probes(const Row& row)
{
  for (int n = 0; n < row.count(); ++n) {
    const ContactStiffness k = row.stiffness(n);
    const Contact contact{row.i(n),     row.j(n),          row.normal(n),
                          row.force(n), row.arm_i(n),      row.distance(n),
                          k.normal,     k.shear,           row.stored_energy(n),
                          row.share(n), row.is_sliding(n), kind_of(row.j(n))};
    for (ContactProbe* probe : active_) probe->add_contact(contact);
  }
}

template void ContactDesk::tell_probes(const ContactRow&);
template void ContactDesk::tell_probes(const RollingRow&);

}  // namespace encased_column
