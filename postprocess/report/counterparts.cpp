// SPDX-License-Identifier: GPL-2.0-only
#include "report/page_parts.h"

#include <algorithm>

namespace encased_column {

namespace {

enum class Needs { nothing, encased, plain, sleeve, spheres, pictures, series };

struct Counterpart {
  std::string study, shows;
  std::vector<std::string> figures;  ///< what the names of those begin with that may stand for it
  Needs needs;
  std::vector<std::string> pictures{};  ///< names of their kinds
};

const std::vector<Counterpart> counterparts{
    {"3", "deviatoric stress over axial strain, plain", {"deviatoric_stress"}, Needs::plain},
    {"7a", "deviatoric stress over axial strain, encased", {"deviatoric_stress"}, Needs::encased},
    {"7b", "failure lines", {"p_q"}, Needs::series},
    {"8", "radial strain at three heights", {"radial_strain"}, Needs::sleeve},
    {"9",
     "shape, displacement and shear bands after shear",
     {},
     Needs::pictures,
     {"specimen", "hoop_tension", "shear_band"}},
    {"11a",
     "pressure over displacement",
     {"pressure_displacement", "column_pressure"},
     Needs::nothing},
    {"11b",
     "radial displacement along the height",
     {"radial_profile", "column_profile"},
     Needs::sleeve},
    {"12", "axial and radial stress along the height", {"column_stress"}, Needs::spheres},
    {"13",
     "contact forces and force chains",
     {"contact_force"},
     Needs::spheres,
     {"force_chains", "force_levels"}},
    {"14", "porosity over displacement and height", {"column_porosity"}, Needs::spheres},
    {"15",
     "coordination number over displacement and height",
     {"column_coordination"},
     Needs::spheres},
    {"16, 18", "pressure over displacement, several columns", {}, Needs::series},
    {"17, 19",
     "radial displacement at 12 and 24 mm",
     {"radial_expansion", "column_expansion"},
     Needs::sleeve},
};

std::string reason(Needs needs)
{
  switch (needs) {
    case Needs::encased:
      return "no: this test is plain";
    case Needs::plain:
      return "no: this test is encased";
    case Needs::sleeve:
      return "no: the run wrote no profile of a sleeve";
    case Needs::spheres:
      return "no: the run wrote no measuring spheres";
    case Needs::pictures:
      return "no: the run wrote no grains to draw";
    case Needs::series:
      return "in the report of the series";
    case Needs::nothing:
      break;
  }
  return "no";
}

std::string stands_beside(const Counterpart& row, const TestResult& test,
                          const std::vector<Figure>& figures, const std::vector<Picture>& pictures)
{
  if (row.needs == Needs::series) return reason(row.needs);
  if (row.needs == Needs::plain && test.run->encased()) return reason(row.needs);
  if (row.needs == Needs::encased && !test.run->encased()) return reason(row.needs);
  std::string found;
  for (const Figure& figure : figures)
    for (const std::string& start : row.figures)
      if (found.empty() && figure.name.rfind(start, 0) == 0) found = figure.title;
  std::string shown = found.empty() ? "Pictures: " : "; pictures: ";
  for (const Picture& picture : pictures)
    if (std::find(row.pictures.begin(), row.pictures.end(), picture.name) != row.pictures.end()) {
      found += shown + picture.title;
      shown = ", ";
    }
  return found.empty() ? reason(row.needs) : found;
}

}  // namespace

Rows counterpart_rows(const TestResult& test, const std::vector<Figure>& figures,
                      const std::vector<Picture>& pictures)
{
  Rows rows{{"figure of the study", "what it shows", "here"}};
  for (const Counterpart& row : counterparts)
    rows.push_back({row.study, row.shows, stands_beside(row, test, figures, pictures)});
  return rows;
}

}  // namespace encased_column
