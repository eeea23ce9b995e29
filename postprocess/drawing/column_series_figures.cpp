// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/column_panels.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "tables/target_record.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace encased_column {

namespace {

/// Gradation and density of the study's column, which its other columns are compared with.
TargetCondition usual_column(const Targets& targets)
{
  const std::optional<TargetRow> row = column_row(targets, "bearing capacity");
  return row ? row->words() : TargetCondition{};
}

ColumnCurves curves_of(const std::vector<const TestResult*>& tests,
                       std::string (*label)(const TestResult&))
{
  ColumnCurves curves;
  for (const TestResult* test : tests) {
    const auto same = std::count_if(tests.begin(), tests.end(), [&](const TestResult* other) {
      return label(*other) == label(*test);
    });
    const std::size_t number = curves.size();
    curves.push_back({test, label(*test) + (same > 1 ? ", " + test->run->id : ""), palette(number),
                      stroke_of_number(number)});
  }
  return curves;
}

std::string gradation_of(const TestResult& test)
{
  return test.run->gradation.empty() ? test.run->id : test.run->gradation;
}

Comparison densities(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::vector<const TestResult*> tests;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      if (test.run->gradation == usual_column(targets).gradation) tests.push_back(&test);
  std::stable_sort(tests.begin(), tests.end(), [](const TestResult* a, const TestResult* b) {
    return a->density.relative_density.value_or(2.0) < b->density.relative_density.value_or(2.0);
  });
  return {"density", "at several relative densities", curves_of(tests, density_label)};
}

/// Columns of other gradations, and that of the usual one that is as dense as the study's column;
/// none if there are no others.
Comparison gradations(const std::vector<SetResult>& sets, const Targets& targets)
{
  const TargetCondition usual = usual_column(targets);
  std::vector<const TestResult*> tests;
  bool others = false;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests) {
      TestCondition condition = test_condition(test);
      if (condition.gradation != usual.gradation)
        others = true;
      else if (!meets(condition, usual, {}))
        continue;
      tests.push_back(&test);
    }
  if (!others) tests.clear();
  std::stable_sort(tests.begin(), tests.end(), [](const TestResult* a, const TestResult* b) {
    return a->run->gradation < b->run->gradation;
  });
  return {"gradation", "of several gradations", curves_of(tests, gradation_of)};
}

/// `figures` with one more of those `panels` that show something.
void add(std::vector<Figure>& figures, Figure figure)
{
  auto& panels = figure.panels;
  panels.erase(std::remove_if(panels.begin(), panels.end(),
                              [](const Panel& panel) { return panel.series.empty(); }),
               panels.end());
  if (!panels.empty()) figures.push_back(std::move(figure));
}

void add_comparison(std::vector<Figure>& figures, const Comparison& columns,
                    const std::string& pressures, const std::string& numbers,
                    const std::string& expansions, const std::string& depths,
                    const Targets& targets)
{
  if (columns.curves.empty()) return;
  add(figures, {"column_pressure_" + columns.name,
                "Vertical pressure over displacement, columns " + columns.title,
                "Counterpart of the study's " + pressures +
                    ". It calls this the pressure at the top; its triaxial tests are read at the "
                    "base." +
                    (columns.marked() ? " " + numbers : ""),
                {pressure_panel(columns, "upper", &ShearRecord::stress_top, targets),
                 pressure_panel(columns, "lower", &ShearRecord::stress_bottom, targets)}});
  constexpr double early = 0.012, late = 0.024;  // m, of Figures 17 and 19
  add(figures,
      {"column_expansion_" + columns.name,
       "Radial displacement along columns " + columns.title,
       "Counterpart of the study's " + expansions +
           "; straight between the profiles before and after." +
           (columns.marked() ? " Grey: " + depths : ""),
       {expansion_panel(columns, early, targets), expansion_panel(columns, late, targets)}});
}

const char* const depths_of_column =
    "how deep below the upper platen the study finds the largest expansion of its column, and all "
    "that is pronounced.";

bool any_repeats(const SetResult& set)
{
  return std::any_of(set.tests.begin(), set.tests.end(), repeats_study);
}

std::vector<Figure> column_series_figures_of_set(const std::vector<SetResult>& sets,
                                                 const Targets& targets)
{
  std::vector<Figure> figures;
  if (sets.front().set != "column") return figures;
  const Comparison by_density = densities(sets, targets), by_gradation = gradations(sets, targets);
  add_comparison(figures, by_density, "Figures 11a and 16",
                 "The black disc and the grey line: its numbers.", "Figure 17", depths_of_column,
                 targets);
  add_comparison(figures, by_gradation, "Figure 18",
                 "Short bars: its numbers at 24 mm, side by side about there.", "Figure 19",
                 "between which depths below the upper platen the study finds pronounced "
                 "expansion; upright: its largest.",
                 targets);
  std::vector<Panel> panels;
  const auto labels = test_labels(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t)
      panels.push_back(stages_panel(sets[s].tests[t], labels[s][t], targets));
  add(figures, {"column_profile", "Radial displacement along each column",
                "Counterpart of the study's Figure 11b." +
                    (std::any_of(sets.begin(), sets.end(), any_repeats)
                         ? std::string(" Grey: ") + depths_of_column
                         : std::string()),
                panels});
  return figures;
}

}  // namespace

std::vector<Figure> column_series_figures(const std::vector<SetResult>& sets,
                                          const Targets& targets)
{
  return drawn_by_parameters(
      sets, [&](const auto& group) { return column_series_figures_of_set(group, targets); });
}

}  // namespace encased_column
