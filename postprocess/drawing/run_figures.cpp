// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "files/column_names.h"

#include <algorithm>
#include <utility>

namespace encased_column {

namespace {

Series limit(const std::string& label, double end_of_strain, double value)
{
  return {label, {0.0, 100.0 * end_of_strain}, {value, value}, grey, Stroke::dash_dotted};
}

Figure energy(const TestResult& test)
{
  static const std::vector<std::pair<ColumnName, const char*>> terms{
      {history_column::work_platens, "work of the platens"},
      {history_column::work_side, "work of the side"},
      {history_column::work_gravity, "work of gravity"},
      {history_column::loss_friction, "lost: friction"},
      {history_column::loss_rolling, "lost: rolling"},
      {history_column::loss_dashpots, "lost: dashpots"},
      {history_column::loss_damping, "lost: local damping"},
      {history_column::energy_elastic, "stored: elastic"},
      {history_column::energy_kinetic, "stored: kinetic"},
      {history_column::loss_yielding, "lost: yielding"},
  };
  Panel panel;
  panel.title = "Energy balance of " + test.run->id;
  panel.x = {axial_strain_title, false, 0.0, {}};
  panel.y = {"energy [J]"};
  std::size_t color = 0;
  for (const auto& [column, label] : terms) {
    if (!test.run->history.has(column)) continue;  // of a history older than the column
    const std::string name = label;
    const Stroke stroke = name[0] == 'w'   ? Stroke::solid
                          : name[0] == 'l' ? Stroke::dashed
                                           : Stroke::dash_dotted;
    panel.series.push_back({name, percent(test.axial_strain), test.run->history.numbers(column),
                            palette(color++), stroke});
  }
  return {"energy_" + test.run->id,
          "Where the work of the test went",
          "Since the start of shear; compression of the specimen does positive work.",
          {panel}};
}

Figure checks_of_set(const std::vector<SetResult>& sets)
{
  const Axis strain{axial_strain_title, false, 0.0, {}};
  Panel unbalanced{
      "Unbalanced force ratio, limit for the start of shear", strain, {"ratio [-]", true}, {}};
  Panel inertial{"Inertial number", strain, {"inertial number I [-]", true}, {}};
  Panel platens{"Platen difference (top - bottom) / mean, limit for 1 % strain averages",
                strain,
                {"difference [%]"},
                {}};
  const auto labels = test_labels(sets);
  const auto colors = color_numbers(sets);
  double end = 0.0;
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t) {
      const ShearRecord& record = sets[s].tests[t].record;
      const std::vector<double> x = percent(record.axial_strain);
      const Color color = palette(colors[s][t]);
      const Stroke stroke = stroke_of(sets[s], sets.size(), colors[s][t]);
      const std::string& label = labels[s][t];
      unbalanced.series.push_back({label, x, record.unbalanced_ratio, color, stroke});
      inertial.series.push_back({label, x, record.inertial_number, color, stroke});
      if (!sets[s].tests[t].run->encased())  // a sleeve takes load: figure platens shows how much
        platens.series.push_back({label, x, percent(platen_differences(record)), color, stroke});
      end = std::max(end, record.axial_strain.back());
    }
  unbalanced.series.push_back(limit("allowed", end, 1e-5));
  inertial.series.push_back(limit("allowed", end, 1e-3));
  std::vector<Panel> panels{unbalanced, inertial};
  if (!platens.series.empty()) {
    platens.series.push_back(limit("allowed", end, 3.0));
    platens.series.push_back(limit("", end, -3.0));
    panels.push_back(platens);
  }
  return {"checks", "Equilibrium, rate and platens during shear",
          "Grey: what is allowed; the unbalanced ratio is a condition for the start of shear only.",
          panels};
}

}  // namespace

Figure check_figure(const std::vector<SetResult>& sets)
{
  const FigureMaker make = [](const auto& group) {
    return std::vector<Figure>{checks_of_set(group)};
  };
  return drawn_by_parameters(sets, make).front();
}

std::vector<Figure> energy_figures(const std::vector<SetResult>& sets)
{
  std::vector<Figure> figures;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests) figures.push_back(energy(test));
  return figures;
}

}  // namespace encased_column
