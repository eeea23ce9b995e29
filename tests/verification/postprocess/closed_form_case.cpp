// SPDX-License-Identifier: GPL-2.0-only
#include "closed_form_case.h"

#include <cmath>
#include <fstream>

namespace encased_column::testing {

namespace fs = std::filesystem;

void describe_case(const fs::path& folder, const std::string& kind, const std::string& variables,
                   const std::string& reproduces)
{
  std::ofstream(folder / "case.json")
      << "{\"id\": " << folder.filename() << ", \"deck\": \"triaxial_" << kind
      << "\", \"title\": \"A test, " << kind << ", at 50 kPa\", \"reproduces\": \"" << reproduces
      << "\", \"variables\": {" << variables << "}}\n";
}

void write_case(const fs::path& folder, const std::string& kind, bool core, double factor,
                double strength, double height)
{
  fs::create_directories(folder);
  describe_case(folder, kind, R"("sigma3": 50000, "radius": 0.05, "resolution": "quick")");
  const bool encased = kind == "encased";
  if (encased) fs::create_directories(folder / "sleeve");  // where a sleeve leaves its files
  std::ofstream history(folder / "history.csv");
  history << "axial_strain [-],stress_top [Pa],stress_bottom [Pa],confining_stress [Pa],"
             "deviatoric_stress_top [Pa],deviatoric_stress_bottom [Pa],volumetric_strain [-],"
             "height [m],step [-],radius [m],porosity [-],porosity_less_overlap "
             "[-],radial_strain_25 [-],"
             "radial_strain_50 [-],radial_strain_75 [-],unbalanced_average [-],"
             "inertial_number [-],energy_error [-],work_platens [J],work_side [J],"
             "work_gravity [J],loss_friction [J],loss_rolling [J],loss_dashpots [J],"
             "loss_damping [J],energy_elastic [J],energy_kinetic [J],"
          << (core ? "core_axial_stress [Pa],core_radial_stress [Pa]\n" : "-,-\n");
  for (int i = 0; i <= 220; ++i) {
    const double strain = 0.001 * i, share = i == 0 ? 0.0 : factor * strength;
    const double top = share * (encased ? q_top : q_plain);
    const double bottom = share * (encased ? q_bottom : q_plain);
    const double side = factor * sigma3;
    history << strain << ',' << side + top << ',' << side + bottom << ',' << side << ',' << top
            << ',' << bottom << ",0," << height * (1.0 - strain) << ',' << 100 * i << ','
            << 0.05 / std::sqrt(1.0 - strain) << ",0.34,0.35," << -0.25 * strain << ','
            << -0.5 * strain << ',' << -0.75 * strain << ",1e-6,1e-4,1e-4,"
            << "0,0,0,0,0,0,0,0,0," << kp_of_core * core_radial << ',' << core_radial << '\n';
  }
}

}  // namespace encased_column::testing
