// SPDX-License-Identifier: GPL-2.0-only
#include "measure/specimen_sums.h"

#include "dynamics/inertia.h"
#include "files/column_names.h"
#include "measure/seen_contact.h"

namespace encased_column {

namespace {

template <int level>
double radial_strain(const SpecimenSample& s)
{
  return shortening(s.before.state.radius[level], s.now.state.radius[level]);
}

/// Of a work or a loss what came since the reference [J].
template <double EnergyAccount::*term>
double since_reference(const SpecimenSample& s)
{
  return s.now.energy.*term - s.before.energy.*term;
}

ContactCount contact_count(const SpecimenSample& s)
{
  return {s.sums.grains, s.sums.ends, s.sums.without_contact, s.sums.with_one_contact};
}

double inertial_number_of(const SpecimenSample& s)
{
  const double p = s.mean_stress();
  return p > 0.0 ? inertial_number(s.strain_rate, s.sums.diameter / s.sums.mass,
                                   s.sums.inertia / s.sums.solid, p)
                 : 0.0;
}

}  // namespace

const std::vector<Column<SpecimenSample>>& specimen_columns()
{
  namespace of = history_column;
  using Energy = EnergyAccount;
  static const std::vector<Column<SpecimenSample>> columns{
      {of::step, "of the sample", [](const SpecimenSample& s) { return s.step; }},
      {of::axial_strain, "of the height between the platens",
       [](const SpecimenSample& s) {
         return shortening(s.before.state.height, s.now.state.height);
       }},
      {of::stress_top, "of the upper platen, on the cross section",
       [](const SpecimenSample& s) { return s.now.state.stress_top; }},
      {of::stress_bottom, "of the lower platen",
       [](const SpecimenSample& s) { return s.now.state.stress_bottom; }},
      {of::confining_stress, "of the side",
       [](const SpecimenSample& s) { return s.now.state.confining_stress; }},
      {of::deviatoric_stress_top, "upper platen's less confining stress",
       [](const SpecimenSample& s) {
         return deviatoric_stress(s.now.state.stress_top, s.now.state.confining_stress);
       }},
      {of::deviatoric_stress_bottom, "lower platen's less confining stress",
       [](const SpecimenSample& s) {
         return deviatoric_stress(s.now.state.stress_bottom, s.now.state.confining_stress);
       }},
      {of::mean_stress, "p = (mean of the platens + 2 confining) / 3",
       [](const SpecimenSample& s) { return s.mean_stress(); }},
      {of::volumetric_strain, "of the volume enclosed",
       [](const SpecimenSample& s) {
         return shortening(s.before.state.volume, s.now.state.volume);
       }},
      {of::height, "between the platens",
       [](const SpecimenSample& s) { return s.now.state.height; }},
      {of::radius, "at mid height", [](const SpecimenSample& s) { return s.now.state.radius[1]; }},
      {of::porosity, "1 - V_s / V, overlaps counted twice in V_s",
       [](const SpecimenSample& s) { return porosity(s.sums.solid, s.now.state.volume); }},
      {of::porosity_less_overlap, "the same, overlaps counted once",
       [](const SpecimenSample& s) {
         return porosity(s.sums.solid - s.sums.shared, s.now.state.volume);
       }},
      {of::coordination_number, "contacts per grain, those with walls included",
       [](const SpecimenSample& s) { return coordination_number(contact_count(s)); }},
      {of::mechanical_coordination_number, "the same without grains of no or one contact",
       [](const SpecimenSample& s) { return mechanical_coordination_number(contact_count(s)); }},
      {of::radial_strain_25, "of the side at 1/4 of the height", radial_strain<0>},
      {of::radial_strain_50, "at 1/2", radial_strain<1>},
      {of::radial_strain_75, "at 3/4", radial_strain<2>},
      {of::unbalanced_average, "see `fix motion`",
       [](const SpecimenSample& s) { return s.unbalanced_ratio.average; }},
      {of::unbalanced_maximum, "see `fix motion`",
       [](const SpecimenSample& s) { return s.unbalanced_ratio.maximum; }},
      {of::inertial_number, "I = rate d sqrt(rho / p), d the mean by mass, rho of the inertia",
       inertial_number_of},
      {of::work_platens, "done on the grains by the platens",
       since_reference<&Energy::work_platens>},
      {of::work_side, "by the side", since_reference<&Energy::work_side>},
      {of::work_gravity, "by gravity", since_reference<&Energy::work_gravity>},
      {of::energy_elastic, "stored in contacts and sleeve",
       [](const SpecimenSample& s) { return s.now.energy.elastic; }},
      {of::energy_kinetic, "of motion, with the inertial mass",
       [](const SpecimenSample& s) { return s.now.energy.kinetic; }},
      {of::loss_friction, "turned into heat by sliding", since_reference<&Energy::friction>},
      {of::loss_rolling, "by rolling resistance", since_reference<&Energy::rolling>},
      {of::loss_dashpots, "by dashpots", since_reference<&Energy::dashpots>},
      {of::loss_damping, "by local damping", since_reference<&Energy::damping>},
      {of::energy_error, "what the energies miss, over all that took part",
       [](const SpecimenSample& s) { return s.energy_error; }},
      {of::core_axial_stress, "Love-Weber stress of the grains in the middle third of the height",
       [](const SpecimenSample& s) { return s.core_stress(s.sums.core_axial); }},
      {of::core_radial_stress, "of the same, away from the axis",
       [](const SpecimenSample& s) { return s.core_stress(s.sums.core_radial); }},
      {of::loss_yielding, "by yielding and tearing of the sleeve",
       since_reference<&Energy::yielding>},
      {of::unbalanced_bearing, "as `unbalanced_average`, grains that bear no load as balanced",
       [](const SpecimenSample& s) { return s.unbalanced_ratio.bearing; }},
  };
  return columns;
}

}  // namespace encased_column
