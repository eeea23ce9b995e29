#include "reading/sleeve_files.h"

#include "files/column_names.h"
#include "reading/text_table.h"

namespace encased_column {

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
