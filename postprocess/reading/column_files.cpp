// SPDX-License-Identifier: GPL-2.0-only
#include "reading/column_files.h"

#include "analysis/sampled_curve.h"
#include "files/column_names.h"
#include "reading/text_table.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// Axial strain [-] of the specimen at each of `steps`.
std::vector<double> strains_at(const std::vector<double>& steps, const TextTable& history)
{
  const SampledCurve strain(history.numbers(history_column::step),
                            history.numbers(history_column::axial_strain));
  std::vector<double> strains;
  for (const double step : steps) strains.push_back(strain.value(step));
  return strains;
}

template <typename Sample>
void fill(std::vector<Sample>& rows, double Sample::*member, const std::vector<double>& values)
{
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row].*member = values[row];
}

}  // namespace

std::vector<SphereSeries> read_spheres(const CaseRun& run)
{
  const fs::path file = run.folder / "spheres.csv";
  if (!fs::exists(file)) return {};
  const TextTable table(file);
  static const std::vector<std::pair<ColumnName, double SphereSample::*>> columns{
      {sphere_column::z, &SphereSample::height},
      {sphere_column::grains, &SphereSample::grains},
      {sphere_column::porosity, &SphereSample::porosity},
      {sphere_column::porosity_less_overlap, &SphereSample::porosity_less_overlap},
      {sphere_column::coordination_number, &SphereSample::coordination_number},
      {sphere_column::axial_stress, &SphereSample::axial_stress},
      {sphere_column::radial_stress, &SphereSample::radial_stress},
      {sphere_column::mean_contact_force, &SphereSample::mean_force},
      {sphere_column::largest_contact_force, &SphereSample::largest_force}};
  std::vector<SphereSample> rows(table.rows());
  fill(rows, &SphereSample::axial_strain,
       strains_at(table.numbers(sphere_column::step), run.history));
  for (const auto& [name, member] : columns) fill(rows, member, table.numbers(name));
  return sphere_series(table.numbers(sphere_column::sphere), rows);
}

std::vector<ContactSample> read_contacts(const CaseRun& run)
{
  const fs::path file = run.folder / "contacts.csv";
  if (!fs::exists(file)) return {};
  const TextTable table(file);
  std::vector<ContactSample> rows(table.rows());
  fill(rows, &ContactSample::axial_strain,
       strains_at(table.numbers(contact_column::step), run.history));
  fill(rows, &ContactSample::contacts, table.numbers(contact_column::contacts));
  fill(rows, &ContactSample::mean_force, table.numbers(contact_column::mean_force));
  fill(rows, &ContactSample::largest_force, table.numbers(contact_column::largest_force));
  for (const std::string& heading : table.headings()) {
    const std::optional<double> level = level_of_share(heading);
    if (!level) continue;
    const std::vector<double> shares = table.numbers(heading);
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].share[*level] = shares[row];
  }
  return rows;
}

namespace fs = std::filesystem;

std::optional<SleeveRecord> read_sleeve_record(const fs::path& folder)
{
  const fs::path file = folder / "sleeve.csv";
  if (!fs::exists(file)) return std::nullopt;
  const TextTable table(file);
  SleeveRecord record;
  record.axial_strain = table.numbers(sleeve_column::axial_strain);
  record.hoop_tension_mean = table.numbers(sleeve_column::hoop_tension_mean);
  record.hoop_tension_max = table.numbers(sleeve_column::hoop_tension_max);
  record.hoop_strain_mean = table.numbers(sleeve_column::hoop_strain_mean);
  record.hoop_strain_max = table.numbers(sleeve_column::hoop_strain_max);
  record.friction_force = table.numbers(sleeve_column::friction_force);
  record.enclosed_volume = table.numbers(sleeve_column::enclosed_volume);
  return record;
}

std::vector<SleeveProfile> read_sleeve_profiles(const fs::path& folder)
{
  const fs::path file = folder / "profile.csv";
  if (!fs::exists(file)) return {};
  const TextTable table(file);
  return profiles_of({table.numbers(profile_column::step),
                      table.numbers(profile_column::axial_strain), table.numbers(profile_column::z),
                      table.numbers(profile_column::radial_displacement)});
}

}  // namespace encased_column
