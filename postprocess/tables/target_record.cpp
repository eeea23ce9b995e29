// SPDX-License-Identifier: GPL-2.0-only
#include "tables/target_record.h"

#include "files/column_names.h"
#include "reading/strip_table.h"

namespace encased_column {

namespace {

/// Stress on the platen that is read [Pa].
std::vector<double> pressure_of(const TestResult& test)
{
  const ShearRecord& record = test.record;
  if (test.platen == Platen::top) return record.stress_top;
  if (test.platen == Platen::bottom) return record.stress_bottom;
  std::vector<double> mean;
  for (std::size_t i = 0; i < record.stress_top.size(); ++i)
    mean.push_back(0.5 * (record.stress_top[i] + record.stress_bottom[i]));
  return mean;
}

}  // namespace

SpecimenShape specimen_shape(const TestResult& test)
{
  const CaseRun& run = *test.run;
  const double height = initial_height(test);
  const double radius = run.history.numbers(history_column::radius).front();
  constexpr double upper = 1.0;  // platen, as the decks have it where they say nothing
  return {2.0 * run.number("radius").value_or(radius), run.number("height").value_or(height),
          height, static_cast<int>(run.number("moving").value_or(upper))};
}

TestCondition test_condition(const TestResult& test)
{
  const SpecimenShape shape = specimen_shape(test);
  return {test.run->confining_stress, test.density.relative_density, shape.built / shape.diameter,
          test.run->gradation};
}

TargetRecord target_record(const SetResult& set, const TestResult& test)
{
  const CaseRun& run = *test.run;
  TargetRecord record{};
  record.shape = specimen_shape(test);
  for (const double strain : test.axial_strain)
    record.displacement.push_back(strain * record.shape.height);
  record.pressure = pressure_of(test);
  record.secant_modulus = test.secant_modulus;
  record.peak = test.peak.reported;
  if (set.line && of_study(set)) {
    const Strength strength = strength_of(*set.line);
    record.friction_angle = strength.friction_angle;
    record.cohesion = strength.cohesion;
  }
  if (test.grains) record.grains = static_cast<double>(*test.grains);
  record.generation_porosity = run.generation_porosity;
  record.porosity = run.history.numbers(history_column::porosity_less_overlap).front();
  if (run.encased())
    // Histories count the radius getting shorter as positive, the study its expansion.
    for (const ColumnName& column :
         {history_column::radial_strain_25, history_column::radial_strain_50,
          history_column::radial_strain_75})
      record.expansion_at_the_end.push_back(-run.history.numbers(column).back());
  record.profiles = test.profiles;
  record.spheres = test.spheres;
  record.contacts = test.contacts;
  const StripTable strip = strip_table(run);
  record.strip_strain = strip.strain;
  record.strip_tension = strip.hoop_tension;
  return record;
}

}  // namespace encased_column
