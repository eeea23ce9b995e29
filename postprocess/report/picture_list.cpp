// SPDX-License-Identifier: GPL-2.0-only
#include "report/page_parts.h"

namespace encased_column {

namespace {

struct Kind {
  std::string name;  ///< of the file, before _ and the run's id
  std::string title, shows, caption;
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
     "Contacts at the end of the run, as bars as thick as their force and coloured by it [N], "
     "before the outline of the specimen",
     "Counterpart of the study's Figure 13; contacts that bear less than 5 N, or than the run "
     "wrote, are left out."},
};

}  // namespace

std::vector<Picture> pictures_of(const CaseRun& run, const std::filesystem::path& folder, int width)
{
  std::vector<Picture> pictures;
  for (const Kind& kind : kinds) {
    const std::filesystem::path file = folder / (kind.name + "_" + run.id + ".png");
    if (!std::filesystem::exists(file)) continue;
    pictures.push_back({kind.name, kind.title, picture_data(file, width),
                        run.title + ". " + kind.shows + ". " + kind.caption,
                        kind.shows + ": " + run.title});
  }
  return pictures;
}

}  // namespace encased_column
