#include "page/picture_list.h"

namespace encased_column {

namespace {

struct Kind {
  std::string name;  ///< of the file, before the run's id
  std::string shows, caption;
};

const std::vector<Kind> kinds{
    {"specimen_", "Grains at the end of the run, coloured by displacement [mm]",
     "The study's Figure 9 shows its encased specimens so."},
    {"hoop_tension_",
     "Deformed sleeve at the end of the run, coloured by hoop tension [kN/m], a quarter cut out",
     "The study shows the shape in its Figure 9."},
};

}  // namespace

std::vector<Picture> pictures_of(const CaseRun& run, const std::filesystem::path& folder, int width)
{
  std::vector<Picture> pictures;
  for (const Kind& kind : kinds) {
    const std::filesystem::path file = folder / (kind.name + run.id + ".png");
    if (!std::filesystem::exists(file)) continue;
    pictures.push_back({picture_data(file, width),
                        run.title + ". " + kind.shows + ". " + kind.caption,
                        kind.shows + ": " + run.title});
  }
  return pictures;
}

}  // namespace encased_column
