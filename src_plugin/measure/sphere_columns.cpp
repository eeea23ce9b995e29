// SPDX-License-Identifier: GPL-2.0-only
#include "files/column_names.h"
#include "measure/sphere_sampler.h"

namespace encased_column {

namespace {

/// Off the diagonal the mean of both triangles.
template <int a, int b>
double stress(const SphereRow& s)
{
  return a == b ? s.measure.stress(a, b) : 0.5 * (s.measure.stress(a, b) + s.measure.stress(b, a));
}

template <int a, int b>
double fabric(const SphereRow& s)
{
  return a == b ? s.measure.fabric(a, b) : 0.5 * (s.measure.fabric(a, b) + s.measure.fabric(b, a));
}

}  // namespace

const std::vector<Column<SphereRow>>& sphere_columns()
{
  namespace of = sphere_column;
  static const std::vector<Column<SphereRow>> columns{
      {of::step, "of the sample", [](const SphereRow& s) { return s.step; }},
      {of::sphere, "number of the sphere, from 1", [](const SphereRow& s) { return s.number; }},
      {of::x, "of its center", [](const SphereRow& s) { return s.sphere.center.x(); }},
      {of::y, "of its center", [](const SphereRow& s) { return s.sphere.center.y(); }},
      {of::z, "of its center", [](const SphereRow& s) { return s.sphere.center.z(); }},
      {of::radius, "of the sphere", [](const SphereRow& s) { return s.sphere.radius; }},
      {of::grains, "with their center inside; below 2000 a warning, once",
       [](const SphereRow& s) { return s.measure.grains; }},
      {of::porosity, "grains across the surface count by the part inside, overlaps twice as solid",
       [](const SphereRow& s) { return s.measure.porosity; }},
      {of::porosity_less_overlap, "the same, overlaps counted once",
       [](const SphereRow& s) { return s.measure.porosity_less_overlap; }},
      {of::coordination_number, "contacts per grain, walls and sleeve included",
       [](const SphereRow& s) { return s.measure.coordination_number; }},
      {of::mechanical_coordination_number, "the same without grains of no or one contact",
       [](const SphereRow& s) { return s.measure.mechanical_coordination_number; }},
      {of::axial_stress, "along the column's axis, compression positive",
       [](const SphereRow& s) { return s.measure.axial; }},
      {of::radial_stress, "away from the axis",
       [](const SphereRow& s) { return s.measure.radial; }},
      {of::hoop_stress, "around the axis", [](const SphereRow& s) { return s.measure.hoop; }},
      {of::stress_xx,
       "Love-Weber's sum over the grains inside, times (1 - n) / (sum of their volumes)",
       stress<0, 0>},
      {of::stress_yy, "of the same", stress<1, 1>},
      {of::stress_zz, "of the same", stress<2, 2>},
      {of::stress_xy, "of the same, the mean of xy and yx", stress<0, 1>},
      {of::stress_xz, "of the same", stress<0, 2>},
      {of::stress_yz, "of the same", stress<1, 2>},
      {of::fabric_xx, "mean of n n over the contacts with their point inside", fabric<0, 0>},
      {of::fabric_yy, "of the same", fabric<1, 1>},
      {of::fabric_zz, "of the same", fabric<2, 2>},
      {of::fabric_xy, "of the same", fabric<0, 1>},
      {of::fabric_xz, "of the same", fabric<0, 2>},
      {of::fabric_yz, "of the same", fabric<1, 2>},
      {of::sliding_fraction, "of those contacts, where friction is used up",
       [](const SphereRow& s) { return s.measure.sliding_fraction; }},
      {of::mean_contact_force, "of those contacts, magnitudes",
       [](const SphereRow& s) { return s.measure.mean_force; }},
      {of::largest_contact_force, "of those contacts",
       [](const SphereRow& s) { return s.largest_force; }},
  };
  return columns;
}

}  // namespace encased_column
