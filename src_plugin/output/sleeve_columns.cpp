// SPDX-License-Identifier: GPL-2.0-only
#include "output/sleeve_columns.h"

#include "files/column_names.h"

namespace encased_column {

const std::vector<Column<SleeveLevel>>& profile_columns()
{
  namespace of = profile_column;
  using Level = SleeveLevel;
  static const std::vector<Column<Level>> columns{
      {of::step, "of the block", [](const Level& l) { return l.step; }},
      {of::axial_strain, "of the specimen", [](const Level& l) { return l.axial_strain; }},
      {of::z, "mean height of the ring of nodes", [](const Level& l) { return l.point.z; }},
      {of::radius, "mean about the axis", [](const Level& l) { return l.point.radius; }},
      {of::radial_displacement, "its growth since the first block",
       [](const Level& l) { return l.point.radius - l.point.before; }},
      {of::hoop_strain, "that goes with it",
       [](const Level& l) { return (l.point.radius - l.point.before) / l.point.before; }},
      {of::hoop_tension, "of the facets around, by area",
       [](const Level& l) { return l.point.hoop_tension; }},
  };
  return columns;
}

const std::vector<Column<SleeveCurves>>& sleeve_columns()
{
  namespace of = sleeve_column;
  using Row = SleeveCurves;
  static const std::vector<Column<Row>> columns{
      {of::step, "of the row", [](const Row& r) { return r.step; }},
      {of::axial_strain, "of the specimen", [](const Row& r) { return r.axial_strain; }},
      {of::pressure, "from outside", [](const Row& r) { return r.pressure; }},
      {of::hoop_tension_mean, "between the platens, by area",
       [](const Row& r) { return r.summary.hoop_tension; }},
      {of::hoop_tension_max, "of the most loaded facet",
       [](const Row& r) { return r.summary.hoop_tension_max; }},
      {of::hoop_strain_mean, "between the platens, by area",
       [](const Row& r) { return r.summary.hoop_strain; }},
      {of::hoop_strain_max, "of the facet that is stretched most",
       [](const Row& r) { return r.summary.hoop_strain_max; }},
      {of::axial_force_top_end, "what the supports of the upper end take along z",
       [](const Row& r) { return r.axial_force_top; }},
      {of::axial_force_bottom_end, "the same of the lower end",
       [](const Row& r) { return r.axial_force_bottom; }},
      {of::friction_force, "vertical force of all grains on the sleeve",
       [](const Row& r) { return r.friction_force; }},
      {of::enclosed_volume, "between the platens", [](const Row& r) { return r.enclosed_volume; }},
      {of::energy, "stored in the sleeve", [](const Row& r) { return r.energy; }},
      {of::plastic_hoop_strain_max, "of the facet that yielded most",
       [](const Row& r) { return r.summary.plastic_hoop_strain_max; }},
      {of::damage_max, "of the facet that is torn most, 1: through",
       [](const Row& r) { return r.summary.damage_max; }},
      {of::dissipated, "that yielding and tearing took", [](const Row& r) { return r.dissipated; }},
  };
  return columns;
}

}  // namespace encased_column
