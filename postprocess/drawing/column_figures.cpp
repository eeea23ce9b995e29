// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "core/input_error.h"
#include "drawing/labels.h"
#include "tables/target_record.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace encased_column {

namespace {

const Axis strain_axis{axial_strain_title, false, 0.0, {}};

std::string sphere_name(const TestResult& test, std::size_t sphere)
{
  const double height = test.spheres[sphere].front().height;
  return "sphere at " + fixed(1e3 * height, 0) + " mm";
}

/// The quantity along the height at the start of shear and at round axial strains.
Panel along_height(const TestResult& test, const std::string& title, const std::string& axis,
                   double SphereSample::*quantity, double factor)
{
  const Axis height{"height of the sphere [mm]", false, 0.0, 1e3 * initial_height(test)};
  Panel panel{title, {axis}, height, {}};
  const std::vector<double> strains = over_time(test.spheres.front(), &SphereSample::axial_strain);
  std::size_t color = 0;
  for (const std::size_t i : nearest_places(strains, shown_strains(test), shown_tolerance(test))) {
    const std::string displacement = fixed(1e3 * strains[i] * initial_height(test), 1) + " mm";
    panel.series.push_back({"ε₁ = " + fixed(100.0 * strains[i], 1) + " %, " + displacement,
                            scaled(along_column(test.spheres, i, quantity), factor),
                            scaled(along_column(test.spheres, i, &SphereSample::height), 1e3),
                            palette(color++), Stroke::solid, true});
  }
  return panel;
}

/// The quantity of each sphere over the displacement of the platens.
Panel over_displacement(const TestResult& test, const std::string& title, const std::string& axis,
                        double SphereSample::*quantity)
{
  Panel panel{title, {"vertical displacement [mm]", false, 0.0, {}}, {axis}, {}};
  for (std::size_t s = 0; s < test.spheres.size(); ++s)
    panel.series.push_back({sphere_name(test, s),
                            scaled(over_time(test.spheres[s], &SphereSample::axial_strain),
                                   1e3 * initial_height(test)),
                            over_time(test.spheres[s], quantity), palette(s), stroke_of_number(s)});
  return panel;
}

/// Rows of the study's column that tell `quantity` of a test like `test`, which repeats it.
std::vector<TargetRow> told(const TestResult& test, const Targets& targets,
                            const std::string& quantity)
{
  std::vector<TargetRow> rows;
  if (!test.run->column() || !repeats_study(test)) return rows;
  for (const TargetRow& row : targets.rows_of("column", quantity))
    if (row.published.model && meets(test_condition(test), row.words(), {})) rows.push_back(row);
  return rows;
}

/// A grey line across `panel` along its axis of heights or of displacements for each of `rows`, or
/// for both ends of its range.
void mark_start(Panel& panel, const std::vector<TargetRow>& rows, bool along_height)
{
  constexpr double margin = 0.03;  // lest a mark lie on the frame
  (along_height ? panel.x : panel.y).margin = margin;
  const Panel curves = panel;
  std::vector<double> ends{HUGE_VAL, -HUGE_VAL};
  for (const Series& series : curves.series)
    for (const double at : along_height ? series.y : series.x)
      ends = {std::min(ends[0], at), std::max(ends[1], at)};
  for (const TargetRow& row : rows) {
    const auto range = row.words().range;
    std::vector<double> marks{*row.published.model};
    if (range) marks = {range->first, range->second};
    for (const double mark : marks) {
      const std::vector<double> values{mark, mark};
      panel.series.push_back({"study, start: " + in_words(mark), along_height ? values : ends,
                              along_height ? ends : values, grey, Stroke::dash_dotted});
    }
  }
}

Panel marked(Panel panel, const std::vector<TargetRow>& rows, bool along_height)
{
  mark_start(panel, rows, along_height);
  return panel;
}

Panel sphere_forces(const TestResult& test, const std::string& title,
                    double SphereSample::*quantity)
{
  Panel panel{title, strain_axis, {"contact force [N]", false, 0.0, {}}, {}};
  for (std::size_t s = 0; s < test.spheres.size(); ++s)
    panel.series.push_back({sphere_name(test, s),
                            percent(over_time(test.spheres[s], &SphereSample::axial_strain)),
                            over_time(test.spheres[s], quantity), palette(s), stroke_of_number(s)});
  return panel;
}

std::vector<double> values_of(const TestResult& test, double ContactSample::*quantity)
{
  std::vector<double> values;
  for (const ContactSample& sample : test.contacts) values.push_back(sample.*quantity);
  return values;
}

Panel strong_shares(const TestResult& test)
{
  Panel panel{"Share of the contacts that bear a force level",
              strain_axis,
              {"share [%]", false, 0.0, {}},
              {}};
  const std::vector<double> strain = percent(values_of(test, &ContactSample::axial_strain));
  for (const auto& [level, first] : test.contacts.front().share) {
    std::vector<double> shares;
    for (const ContactSample& sample : test.contacts) shares.push_back(sample.share.at(level));
    panel.series.push_back(
        {in_words(level) + " N", strain, percent(shares), palette(panel.series.size())});
  }
  return panel;
}

/// The study's largest force before and after loading.
void mark_forces(Panel& panel, const TestResult& test, const Targets& targets)
{
  for (const auto& [when, strain] :
       {std::pair("before", 0.0), std::pair("after", test.axial_strain.back())})
    for (const TargetRow& row :
         told(test, targets, std::string("largest contact force ") + when + " loading"))
      panel.series.push_back(
          {std::string("study, ") + when + ": " + in_words(*row.published.model) + " N",
           {100.0 * strain},
           {*row.published.model},
           strain > 0.0 ? grey : black,
           Stroke::none,
           true});
}

Figure contact_force(const TestResult& test, const std::string& name, const Targets& targets)
{
  std::vector<Panel> panels;
  if (!test.spheres.empty())
    panels = {sphere_forces(test, "Largest contact force, " + name, &SphereSample::largest_force),
              sphere_forces(test, "Mean contact force, " + name, &SphereSample::mean_force)};
  if (!test.contacts.empty()) {
    if (panels.empty())
      panels = {Panel{"Largest contact force, " + name, strain_axis, {"contact force [N]"}, {}},
                Panel{"Mean contact force, " + name, strain_axis, {"contact force [N]"}, {}}};
    const std::vector<double> strain = percent(values_of(test, &ContactSample::axial_strain));
    panels[0].series.push_back({"whole specimen", strain,
                                values_of(test, &ContactSample::largest_force), black,
                                Stroke::dashed});
    panels[1].series.push_back({"whole specimen", strain,
                                values_of(test, &ContactSample::mean_force), black,
                                Stroke::dashed});
    mark_forces(panels[0], test, targets);
    if (!test.contacts.front().share.empty()) panels.push_back(strong_shares(test));
  }
  return {"contact_force_" + test.run->id, "Contact forces",
          "Statistics to the study's Figure 13; grains are larger than its column's where the "
          "resolution is not paper, and so are the forces.",
          panels};
}

void add_sphere_figures(std::vector<Figure>& figures, const TestResult& test,
                        const std::string& name, const Targets& targets)
{
  const auto porosities = told(test, targets, "initial porosity in measuring spheres");
  const auto coordination = told(test, targets, "initial coordination number");
  const std::string id = "_" + test.run->id;
  figures.push_back(
      {"column_stress" + id,
       "Stress along the column",
       "Counterpart of the study's Figure 12; compression positive, each point the mean of one "
       "measuring sphere.",
       {along_height(test, "Axial stress, " + name, "axial stress [kPa]",
                     &SphereSample::axial_stress, 1e-3),
        along_height(test, "Radial stress, " + name, "radial stress [kPa]",
                     &SphereSample::radial_stress, 1e-3)}});
  figures.push_back(
      {"column_porosity" + id,
       "Porosity along the column",
       "Counterpart of the study's Figure 14; overlaps counted once.",
       {marked(over_displacement(test, "Porosity of the spheres, " + name, "porosity n [-]",
                                 &SphereSample::porosity_less_overlap),
               porosities, false),
        marked(along_height(test, "Porosity along the height, " + name, "porosity n [-]",
                            &SphereSample::porosity_less_overlap, 1.0),
               porosities, true)}});
  figures.push_back(
      {"column_coordination" + id,
       "Coordination number along the column",
       "Counterpart of the study's Figure 15; all grains and contacts count.",
       {marked(over_displacement(test, "Coordination number of the spheres, " + name,
                                 "coordination number [-]", &SphereSample::coordination_number),
               coordination, false),
        marked(along_height(test, "Coordination number along the height, " + name,
                            "coordination number [-]", &SphereSample::coordination_number, 1.0),
               coordination, true)}});
}

}  // namespace

std::vector<Figure> column_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::vector<Figure> figures;
  const auto labels = test_labels(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t) {
      const TestResult& test = sets[s].tests[t];
      if (!test.spheres.empty()) add_sphere_figures(figures, test, labels[s][t], targets);
      if (!test.spheres.empty() || !test.contacts.empty())
        figures.push_back(contact_force(test, labels[s][t], targets));
    }
  return figures;
}

}  // namespace encased_column
