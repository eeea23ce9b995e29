// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "files/column_names.h"
#include "tables/text_layout.h"

#include <algorithm>

namespace encased_column {

namespace {

/// The laboratory's peak of a test like `test` and half of it at its E50; none beside a test that
/// reproduces nothing of the study.
struct LaboratoryMarks {
  std::vector<Series> peaks, halves;
};

void mark_laboratory(LaboratoryMarks& marks, const SetResult& set, const TestResult& test,
                     const Targets& targets, Color color)
{
  if (test.run->reproduces.empty()) return;
  constexpr double begin = 0.25;  // of the strains: where peaks are near
  const std::string condition = confining_condition(test.run->confining_stress);
  const auto peak = targets.find(set.set, "peak deviator q", condition).laboratory;        // kPa
  const auto modulus = targets.find(set.set, "secant modulus E50", condition).laboratory;  // MPa
  if (!peak) return;
  const double end = 100.0 * test.axial_strain.back();
  marks.peaks.push_back({"", {begin * end, end}, {*peak, *peak}, color, Stroke::dash_dotted});
  if (modulus)
    marks.halves.push_back(
        {"", {100.0 * 0.5 * *peak / (1e3 * *modulus)}, {0.5 * *peak}, color, Stroke::none, true});
}

/// A grey line of a legend for the strokes of curves that have the colors of their tests: too short
/// to be seen, or below what is drawn there.
Series legend_key(const std::string& label, Stroke stroke, double x = 0.0, double y = 0.0)
{
  if (stroke == Stroke::none) return {label, {x}, {y}, grey, stroke, true};
  return {label, {x, x}, {y, y}, grey, stroke};
}

Panel both_platens(const SetResult& set, const std::vector<std::string>& labels,
                   const std::vector<std::size_t>& colors, const Targets& targets)
{
  Panel panel{tests_heading(set),
              {axial_strain_title, false, 0.0, {}},
              {"deviatoric stress q [kPa]", false, 0.0, {}},
              {}};
  LaboratoryMarks marks;
  std::vector<Series> curves;
  for (std::size_t t = 0; t < set.tests.size(); ++t) {
    const TestResult& test = set.tests[t];
    const Color color = palette(colors[t]);
    const TextTable& history = test.run->history;
    const std::vector<double> strain = percent(test.axial_strain);
    const auto q = [&](const ColumnName& column) { return scaled(history.numbers(column), 1e-3); };
    curves.push_back({labels[t], strain, q(history_column::deviatoric_stress_bottom), color});
    curves.push_back({"", strain, q(history_column::deviatoric_stress_top), color, Stroke::dashed});
    mark_laboratory(marks, set, test, targets, color);
  }
  panel.series = {legend_key("bottom platen", Stroke::solid),
                  legend_key("top platen", Stroke::dashed)};
  if (!marks.peaks.empty())
    panel.series.push_back(legend_key("laboratory: peak", Stroke::dash_dotted));
  if (!marks.halves.empty())
    panel.series.push_back(legend_key("laboratory: half of the peak at its E50", Stroke::none,
                                      marks.halves.front().x.front(),
                                      marks.halves.front().y.front()));
  for (const std::vector<Series>& more : {curves, marks.peaks, marks.halves})
    panel.series.insert(panel.series.end(), more.begin(), more.end());
  return panel;
}

/// The names of tests without what a panel of plain or encased ones says already.
std::string without_kind(std::string label)
{
  for (const std::string kind : {", plain", ", encased"})
    if (label.size() > kind.size() &&
        label.compare(label.size() - kind.size(), kind.size(), kind) == 0)
      label.erase(label.size() - kind.size());
  return label;
}

bool reproduces_something(const SetResult& set)
{
  return std::any_of(set.tests.begin(), set.tests.end(),
                     [](const TestResult& test) { return !test.run->reproduces.empty(); });
}

std::vector<Figure> agreement_of_set(const std::vector<SetResult>& sets, const Targets& targets)
{
  if (sets.front().set == "column") return {};
  std::vector<Panel> panels;
  auto labels = test_labels(sets);
  const auto colors = color_numbers(sets);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (std::string& label : labels[s]) label = without_kind(label);
    panels.push_back(both_platens(sets[s], labels[s], colors[s], targets));
  }
  if (std::none_of(sets.begin(), sets.end(), reproduces_something))
    return {{"agreement", "Both platens", "Stress on the bottom and on the top platen.", panels}};
  return {{"agreement", "Both platens beside the laboratory",
           "The laboratory's peaks follow from its φ and c; its E50 is known at 50 and 150 kPa.",
           panels}};
}

}  // namespace

std::vector<Figure> agreement_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  const std::vector<Figure> figures = drawn_by_parameters(
      sets, [&](const auto& group) { return agreement_of_set(group, targets); });
  if (!figures.empty()) return figures;
  std::vector<Figure> columns = column_series_figures(sets, targets);
  columns.resize(std::min<std::size_t>(columns.size(), 1));
  return columns;
}

}  // namespace encased_column
