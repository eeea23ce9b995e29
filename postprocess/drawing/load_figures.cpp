// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "files/column_names.h"

#include <algorithm>
#include <utility>

namespace encased_column {

namespace {

const Axis mean_stress{"mean stress p = (σ₁ + 2 σ₃) / 3 [kPa]", false, 0.0, {}};
const Axis deviatoric_stress{"deviatoric stress q [kPa]", false, 0.0, {}};
const ColumnName core_axial = history_column::core_axial_stress;
const ColumnName core_radial = history_column::core_radial_stress;

/// A test with the name and the look of its curves.
struct Curve {
  const TestResult* test;
  std::string label;
  Color color;
  Stroke stroke;

  Series of(const std::vector<double>& x, const std::vector<double>& y) const
  {
    return {label, x, y, color, stroke};
  }
};

std::vector<Curve> curves_of(const std::vector<SetResult>& sets)
{
  std::vector<Curve> curves;
  const auto labels = test_labels(sets);
  const auto colors = color_numbers(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t) {
      const TestResult& test = sets[s].tests[t];
      curves.push_back({&test, labels[s][t], palette(colors[s][t]),
                        stroke_of(sets[s], sets.size(), colors[s][t])});
    }
  return curves;
}

Panel pressure(const std::vector<Curve>& curves, const std::string& platen,
               std::vector<double> ShearRecord::*stress)
{
  Panel panel{"Pressure on the " + platen + " platen",
              {"vertical displacement [mm]", false, 0.0, {}},
              {"vertical pressure [kPa]", false, 0.0, {}},
              {}};
  for (const Curve& curve : curves)
    panel.series.push_back(
        curve.of(scaled(curve.test->axial_strain, 1e3 * initial_height(*curve.test)),
                 scaled(curve.test->record.*stress, 1e-3)));
  return panel;
}

struct Path {
  std::vector<double> p, q;  ///< [kPa]
};

Path path_of(const std::vector<double>& confining, const std::vector<double>& deviatoric)
{
  Path path;
  for (std::size_t i = 0; i < confining.size(); ++i) {
    const StressPoint point = stress_point(confining[i], deviatoric[i]);
    path.p.push_back(point.mean_stress / 1e3);
    path.q.push_back(point.deviatoric_stress / 1e3);
  }
  return path;
}

/// The laboratory's failure line of the set called `set`, as far as the curves of `panel` go.
Series laboratory_line(const Panel& panel, const std::string& set, const Targets& targets)
{
  double highest = 0.0;
  for (const Series& series : panel.series)
    highest = std::max(highest, *std::max_element(series.x.begin(), series.x.end()));
  const auto strength = targets.strength(set, true);
  if (!strength) return {};
  const FailureLine line = failure_line_of(*strength);
  const bool encased = set.find("encased") != std::string::npos;
  return {std::string("laboratory, ") + (encased ? "encased" : "plain"),
          {0.0, highest},
          {line.intercept / 1e3, line.deviatoric_stress(1e3 * highest) / 1e3},
          grey,
          encased ? Stroke::solid : Stroke::dash_dotted};
}

Panel boundary_path(const std::vector<Curve>& curves, const std::vector<SetResult>& sets,
                    const Targets& targets)
{
  Panel panel{"At the boundary", mean_stress, deviatoric_stress, {}};
  for (const Curve& curve : curves) {
    const Path path = path_of(curve.test->record.confining_stress, curve.test->deviatoric_stress);
    panel.series.push_back(curve.of(path.p, path.q));
  }
  std::vector<Series> lines;
  for (const SetResult& set : sets)
    if (of_study(set))
      lines.push_back(
          laboratory_line(panel, set.set == "column" ? "encased_triaxial" : set.set, targets));
  for (Series& line : lines)
    if (!line.x.empty()) panel.series.push_back(std::move(line));
  return panel;
}

/// The grains of the middle third feel the sleeve's confinement too: beside them stands the line of
/// the gravel alone.
Panel core_path(const std::vector<Curve>& curves, const Targets& targets)
{
  Panel panel{"Grains of the middle third", mean_stress, deviatoric_stress, {}};
  for (const Curve& curve : curves) {
    const TextTable& history = curve.test->run->history;
    if (!history.has(core_axial) || !history.has(core_radial)) continue;
    const std::vector<double> radial = history.numbers(core_radial);
    std::vector<double> deviatoric = history.numbers(core_axial);
    for (std::size_t i = 0; i < radial.size(); ++i) deviatoric[i] -= radial[i];
    const Path path = path_of(radial, deviatoric);
    panel.series.push_back(curve.of(path.p, path.q));
  }
  if (panel.series.empty()) return panel;
  const Series line = laboratory_line(panel, "plain_triaxial", targets);
  if (!line.x.empty()) panel.series.push_back(line);
  return panel;
}

std::vector<Figure> load_figures_of_set(const std::vector<SetResult>& sets, const Targets& targets)
{
  const std::vector<Curve> curves = curves_of(sets);
  Figure paths{"stress_path",
               "Stress paths",
               "q at the boundary is that of the platen named above; of the grains it is axial "
               "less radial stress, and p counts what the sleeve adds to the confinement.",
               {boundary_path(curves, sets, targets)}};
  const Panel core = core_path(curves, targets);
  if (!core.series.empty()) paths.panels.push_back(core);
  if (sets.front().set == "column") return {paths};  // column_series_figures() has the rest
  return {{"pressure_displacement",
           "Vertical pressure over displacement",
           "Counterpart of the study's Figure 11a, for the triaxial specimen.",
           {pressure(curves, "upper", &ShearRecord::stress_top),
            pressure(curves, "lower", &ShearRecord::stress_bottom)}},
          paths};
}

}  // namespace

std::vector<Figure> load_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  return drawn_by_parameters(
      sets, [&](const auto& group) { return load_figures_of_set(group, targets); });
}

}  // namespace encased_column
