#include "reading/column_files.h"

#include "analysis/sampled_curve.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// Axial strain [-] of the specimen at each of `steps`.
std::vector<double> strains_at(const std::vector<double>& steps, const TextTable& history)
{
  const SampledCurve strain(history.numbers("step [-]"), history.numbers("axial_strain [-]"));
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
  static const std::vector<std::pair<const char*, double SphereSample::*>> columns{
      {"z [m]", &SphereSample::height},
      {"grains [-]", &SphereSample::grains},
      {"porosity [-]", &SphereSample::porosity},
      {"porosity_less_overlap [-]", &SphereSample::porosity_less_overlap},
      {"coordination_number [-]", &SphereSample::coordination_number},
      {"axial_stress [Pa]", &SphereSample::axial_stress},
      {"radial_stress [Pa]", &SphereSample::radial_stress},
      {"mean_contact_force [N]", &SphereSample::mean_force},
      {"largest_contact_force [N]", &SphereSample::largest_force}};
  std::vector<SphereSample> rows(table.rows());
  fill(rows, &SphereSample::axial_strain, strains_at(table.numbers("step [-]"), run.history));
  for (const auto& [name, member] : columns) fill(rows, member, table.numbers(name));
  return sphere_series(table.numbers("sphere [-]"), rows);
}

std::vector<ContactSample> read_contacts(const CaseRun& run)
{
  const fs::path file = run.folder / "contacts.csv";
  if (!fs::exists(file)) return {};
  const TextTable table(file);
  std::vector<ContactSample> rows(table.rows());
  fill(rows, &ContactSample::axial_strain, strains_at(table.numbers("step [-]"), run.history));
  fill(rows, &ContactSample::contacts, table.numbers("contacts [-]"));
  fill(rows, &ContactSample::mean_force, table.numbers("mean_force [N]"));
  fill(rows, &ContactSample::largest_force, table.numbers("largest_force [N]"));
  for (const std::string& heading : table.headings()) {
    const std::optional<double> level = level_of_share(heading);
    if (!level) continue;
    const std::vector<double> shares = table.numbers(heading);
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].share[*level] = shares[row];
  }
  return rows;
}

}  // namespace encased_column
