// SPDX-License-Identifier: GPL-2.0-only
#include "measure/specimen_sums.h"

#include "dynamics/inertia.h"
#include "measure/seen_contact.h"

#include <type_traits>

namespace encased_column {

static_assert(std::is_trivially_copyable_v<SpecimenSums::Numbers>);
static_assert(sizeof(SpecimenMoment) == SpecimenMoment::count * sizeof(double));

void SpecimenSums::start(const HeightWindow& window, const Vec3& axis)
{
  core_ = window.middle_third();
  axis_ = axis;
  n_ = Numbers{};
}

void SpecimenSums::add(const SeenContact& contact)
{
  add_to_core(contact.at_i, contact.lever_i(), contact.force);
  if (contact.counts_j) add_to_core(contact.at_j, contact.lever_j(), -contact.force);
  n_.shared += contact.share * contact.shared_volume();
  n_.elastic += contact.share * contact.stored_energy;
}

void SpecimenSums::add_to_core(const Vec3& x, const Vec3& lever, const Vec3& force)
{
  if (!core_.holds(x.z())) return;
  Vec3 outward = x - axis_;
  outward.z() = 0.0;
  outward.normalize();
  n_.core_axial += love_weber(force, lever, Vec3::UnitZ());
  n_.core_radial += love_weber(force, lever, outward);
}

void SpecimenSums::add(const SeenGrain& grain, const Vec3& gravity)
{
  n_.grains += 1.0;
  n_.solid += sphere_volume(grain.radius);
  n_.inertia += grain.inertia;
  n_.mass += grain.mass;
  n_.diameter += 2.0 * grain.radius * grain.mass;
  n_.weight_height += grain.mass * gravity.dot(grain.x);
  n_.kinetic += kinetic_energy(grain.inertia, grain.radius, grain.v, grain.omega);
  if (core_.holds(grain.x.z())) n_.core_solid += sphere_volume(grain.radius);
  if (grain.contacts == 0) n_.without_contact += 1.0;
  if (grain.contacts == 1) n_.with_one_contact += 1.0;
  n_.ends += grain.contacts;
}

double SpecimenSample::mean_stress() const
{
  return encased_column::mean_stress(0.5 * (now.state.stress_top + now.state.stress_bottom),
                                     now.state.confining_stress);
}

double SpecimenSample::core_stress(double products) const
{
  const double per_volume =
      sums.core_solid > 0.0 ? sums.solid / now.state.volume / sums.core_solid : 0.0;
  return products * per_volume;
}

}  // namespace encased_column
