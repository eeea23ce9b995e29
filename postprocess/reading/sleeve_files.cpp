#include "reading/sleeve_files.h"

#include "reading/text_table.h"

namespace encased_column {

namespace fs = std::filesystem;

std::optional<SleeveRecord> read_sleeve_record(const fs::path& folder)
{
  const fs::path file = folder / "sleeve.csv";
  if (!fs::exists(file)) return std::nullopt;
  const TextTable table(file);
  SleeveRecord record;
  record.axial_strain = table.numbers("axial_strain [-]");
  record.hoop_tension_mean = table.numbers("hoop_tension_mean [N/m]");
  record.hoop_tension_max = table.numbers("hoop_tension_max [N/m]");
  record.hoop_strain_mean = table.numbers("hoop_strain_mean [-]");
  record.hoop_strain_max = table.numbers("hoop_strain_max [-]");
  record.friction_force = table.numbers("friction_force [N]");
  record.enclosed_volume = table.numbers("enclosed_volume [m^3]");
  return record;
}

std::vector<SleeveProfile> read_sleeve_profiles(const fs::path& folder)
{
  const fs::path file = folder / "profile.csv";
  if (!fs::exists(file)) return {};
  const TextTable table(file);
  return profiles_of({table.numbers("step [-]"), table.numbers("axial_strain [-]"),
                      table.numbers("z [m]"), table.numbers("radial_displacement [m]")});
}

}  // namespace encased_column
