// SPDX-License-Identifier: GPL-2.0-only
#include "report/page_parts.h"

#include "tables/run_variables.h"

namespace encased_column {

namespace {

struct Kind {
  std::string name;  ///< of the file, before _ and the run's id
  std::string title, shows, caption;
  bool wide_if_encased = false;  ///< several views side by side
};

const std::vector<Kind> kinds{
    {"specimen", "displacement", "Grains at the end of the run, coloured by displacement [mm]",
     "The study's Figure 9 shows its encased specimens so."},
    {"shear_band", "shear band",
     "Grains behind a plane through the axis at the end of the run, coloured by the deviatoric "
     "strain about each [%]",
     "Grey: not known. The bands stand beside those that show inside the specimens of the study's "
     "Figure 9."},
    {"hoop_tension", "sleeve",
     "Deformed sleeve at the end of the run, coloured by hoop tension [kN/m], a quarter cut out",
     "The study shows the shape in its Figure 9."},
    {"force_chains", "force chains",
     "Contacts at the end of the run, and of encased runs at the start of shear beside them, as "
     "bars as thick as their force and coloured by it [N], before the outline of the specimen",
     "Counterpart of the study's Figure 13a; contacts that bear less than 5 N, or than the run "
     "wrote, are left out.",
     true},
    {"force_levels", "chains of 20, 40 and 60 N",
     "Contacts at the end of the run that bear 20, 40 and 60 N, side by side; bars and colours [N] "
     "at one scale, before the outline of the specimen",
     "Counterpart of the study's Figure 13b. Forces grow with the square of the grains' size: at a "
     "resolution coarser than paper more contacts bear them.",
     true},
};

}  // namespace

std::vector<Picture> pictures_of(const CaseRun& run, const std::filesystem::path& folder, int width)
{
  std::vector<Picture> pictures;
  for (const Kind& kind : kinds) {
    const std::filesystem::path file = folder / (kind.name + "_" + run.id + ".png");
    if (!std::filesystem::exists(file)) continue;
    pictures.push_back({kind.name, kind.title, picture_data(file, width),
                        run.title + ". " + kind.shows + ". " + kind.caption +
                            " Run: " + run_variables({&run}) + '.',
                        kind.shows + ": " + run.title, kind.wide_if_encased && run.encased()});
  }
  return pictures;
}

}  // namespace encased_column
