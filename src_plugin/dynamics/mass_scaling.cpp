// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/mass_scaling.h"

#include "core/constants.h"
#include "dynamics/inertia.h"

#include <algorithm>
#include <tuple>

namespace encased_column {

namespace {

/// Part of its mass [-] that a grain keeps at least each time masses are found. A contact that
/// opens takes its stiffness with it, and may close again long before masses are found once more: a
/// grain made light at once would then move with an unstable step, and grains that chatter would
/// never come to rest.
constexpr double kept_part = 0.98;

Eigen::Map<Vec3> triple(double* vectors, int i)
{
  return Eigen::Map<Vec3>(vectors + 3 * i);
}

}  // namespace

bool MassScaling::Rule::operator==(const Rule& other) const
{
  return step == other.step && safety == other.safety &&
         stiffest_material == other.stiffest_material && rolling == other.rolling;
}

void MassScaling::begin_step(const MovingGrains& grains, bool way_was_gone)
{
  grains_ = grains;
  way_was_gone_ = way_was_gone;
  // Steps that find no masses are most of all, and leave the memory to others.
  if (way_was_gone) stiffness_ = std::vector<GrainStiffness>();
}

void MassScaling::admit_new_grains()
{
  for (int i = 0; i < grains_.count; ++i)
    if (inertia_[i] == 0.0) inertia_[i] = mass_for(i, one_contact(i));
}

// Before the first contact there may still be a list of pairs to make, which needs memory too.
void MassScaling::clear_contacts()
{
  stiffness_ = std::vector<GrainStiffness>();
}

void MassScaling::add_contact(int i, int j, const Vec3& normal, double normal_stiffness,
                              double shear_stiffness)
{
  if (stiffness_.empty()) stiffness_.resize(grains_.count);
  GrainStiffness& stiffness = stiffness_[i];
  stiffness.add(normal, normal_stiffness, shear_stiffness);
  if (j < 0)
    stiffness.wall =
        std::max(stiffness.wall, wall_stiffness(normal_stiffness, shear_stiffness, rule.rolling));
  else if (j < grains_.count)
    stiffness_[j].add(normal, normal_stiffness, shear_stiffness);
}

double MassScaling::one_contact(int i) const
{
  return pi * grains_.radius[i] * rule.stiffest_material;
}

double MassScaling::mass_for(int i, double stiffness) const
{
  const double mass = grains_.mass[i];
  return rule.scales() ? std::max(mass, mass_for_step(rule.step, stiffness, rule.safety)) : mass;
}

// A grain that touches little now may touch more in the next step: no grain counts as softer than
// one contact with something flat of its own kind makes it. Walls raise the masses of the grains
// they touch. Grains that were made since the contacts were collected have none.
double MassScaling::decisive_stiffness(int i) const
{
  const bool known = i < static_cast<int>(stiffness_.size());
  return std::max(one_contact(i), known ? stiffness_[i].decisive(rule.rolling) : 0.0);
}

MassScaling::Found MassScaling::set_masses()
{
  Found found{1e300, 1.0};
  for (int i = 0; i < grains_.count; ++i) {
    const double stiffness = decisive_stiffness(i);
    const double wanted = std::max(mass_for(i, stiffness), kept_part * inertia_[i]);
    if (wanted != inertia_[i]) change_mass(i, wanted);
    found.largest_factor = std::max(found.largest_factor, wanted / grains_.mass[i]);
    found.stable_step = std::min(found.stable_step, stable_step(wanted, stiffness, rule.safety));
  }
  return found;
}

double MassScaling::kinetic_energy_of(int i) const
{
  return kinetic_energy(inertia_[i], grains_.radius[i], triple(grains_.velocity, i),
                        triple(grains_.spin, i));
}

void MassScaling::change_mass(int i, double wanted)
{
  const double before = kinetic_energy_of(i), added = wanted - inertia_[i];
  auto velocity = triple(grains_.velocity, i), spin = triple(grains_.spin, i);
  if (added > 0.0 && way_was_gone_)
    raised_.push_back({i, added, velocity, spin});
  else {
    const double part = part_of_velocity(inertia_[i], wanted);
    velocity *= part;
    spin *= part;
  }
  inertia_[i] = wanted;
  loss_ += before - kinetic_energy_of(i);
}

void MassScaling::sort_raised()
{
  std::sort(raised_.begin(), raised_.end(), [](const Raised& a, const Raised& b) {
    return std::tie(a.grain, a.added) < std::tie(b.grain, b.added);
  });
}

// Two walls may have raised the mass of one grain in one step: what each added was at rest.
void MassScaling::settle(int end)
{
  for (; raised_before(end); ++settled_) {
    const Raised& raised = raised_[settled_];
    const int i = raised.grain;
    loss_ += kinetic_energy_of(i);
    const double part = raised.added / inertia_[i];
    triple(grains_.velocity, i) -= part * raised.velocity;
    triple(grains_.spin, i) -= part * raised.spin;
    loss_ -= kinetic_energy_of(i);
  }
  if (settled_ < raised_.size()) return;
  raised_.clear();
  settled_ = 0;
}

double MassScaling::take_loss()
{
  const double loss = loss_;
  loss_ = 0.0;
  return loss;
}

}  // namespace encased_column
