#include "drawing/figures.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "tables/target_record.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace encased_column {

namespace {

const Axis displacement_axis{"vertical displacement [mm]", false, 0.0, {}};
const Axis expansion_axis{"radial displacement [mm], expansion positive", false, {}, {}};

/// A column with the look of its curves.
struct ColumnCurve {
  const TestResult* test;
  std::string label;
  Color color;
  Stroke stroke;
};
using ColumnCurves = std::vector<ColumnCurve>;

/// Columns of one gradation and several densities, or of several gradations.
struct Comparison {
  std::string name, title;  ///< of its figures: "density", "several relative densities"
  ColumnCurves curves;
};

/// The row of the study's column that tells `quantity`.
std::optional<TargetRow> column_row(const Targets& targets, const std::string& quantity)
{
  const std::vector<TargetRow> rows = targets.rows_of("column", quantity);
  return rows.empty() ? std::nullopt : std::optional(rows.front());
}

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

Series disc(const std::string& label, double x, double y, Color color)
{
  return {label, {x}, {y}, color, Stroke::none, true};
}

double largest_x(const Panel& panel)
{
  double largest = 0.0;
  for (const Series& series : panel.series)
    for (const double x : series.x) largest = std::max(largest, x);
  return largest;
}

std::string as_published(const TargetRow& row)
{
  return row.published.model ? in_words(*row.published.model) + " " + row.unit : "-";
}

/// The pressures that the study reads from its column, soon after the start and at the end.
void mark_column(Panel& panel, const Targets& targets)
{
  const auto soon = column_row(targets, "vertical pressure soon");
  if (soon && soon->published.model && soon->words().displacement)
    panel.series.push_back(disc("study: " + as_published(*soon) + " soon",
                                1e3 * *soon->words().displacement, *soon->published.model, black));
  const auto capacity = column_row(targets, "bearing capacity");
  if (capacity && capacity->published.model)
    panel.series.push_back({"study: capacity " + as_published(*capacity),
                            {0.0, largest_x(panel)},
                            {*capacity->published.model, *capacity->published.model},
                            grey,
                            Stroke::dash_dotted});
}

/// The rows of the study's gradations that `curve` is of.
std::vector<TargetRow> rows_of(const ColumnCurve& curve, const Targets& targets,
                               const std::string& quantity)
{
  std::vector<TargetRow> rows;
  for (const TargetRow& row : targets.rows_of("column_gradation", quantity))
    if (row.published.model && row.words().displacement &&
        meets(test_condition(*curve.test), row.words(), {}))
      rows.push_back(row);
  return rows;
}

void mark_gradations(Panel& panel, const ColumnCurves& curves, const Targets& targets)
{
  for (const ColumnCurve& curve : curves)
    for (const TargetRow& row : rows_of(curve, targets, "vertical pressure"))
      panel.series.push_back(disc("study, " + curve.label + ": " + as_published(row),
                                  1e3 * *row.words().displacement, *row.published.model,
                                  curve.color));
}

Panel pressure(const Comparison& columns, const std::string& platen,
               std::vector<double> ShearRecord::*stress, const Targets& targets)
{
  Panel panel{"Pressure on the " + platen + " platen",
              displacement_axis,
              {"vertical pressure [kPa]", false, 0.0, {}},
              {}};
  for (const ColumnCurve& curve : columns.curves)
    panel.series.push_back({curve.label,
                            scaled(curve.test->axial_strain, 1e3 * initial_height(*curve.test)),
                            scaled(curve.test->record.*stress, 1e-3), curve.color, curve.stroke});
  if (columns.name == "density")
    mark_column(panel, targets);
  else
    mark_gradations(panel, columns.curves, targets);
  return panel;
}

/// The sleeve between the platens where these have come closer by `displacement` [m].
std::optional<SleeveProfile> shape_at(const TestResult& test, double displacement)
{
  const double strain = displacement / initial_height(test);
  const std::optional<SleeveProfile> profile = profile_at(test.profiles, strain);
  if (!profile) return std::nullopt;
  const SleeveProfile inside = between_platens(*profile, specimen_shape(test).platens(strain));
  return inside.height.empty() ? std::nullopt : std::optional(inside);
}

/// A line across `panel` at the depth below the upper platen that the study tells for `quantity`.
void mark_depth(Panel& panel, const TestResult& test, double displacement, const Targets& targets,
                const std::string& quantity, const std::string& label, Stroke stroke)
{
  const auto row = column_row(targets, quantity);
  if (!row || !row->published.model) return;
  const SpecimenShape shape = specimen_shape(test);
  const double top = shape.platens(displacement / shape.height).top;
  const double height = 1e3 * (top - *row->published.model * shape.diameter);
  double low = 0.0, high = 0.0;
  for (const Series& series : panel.series)
    for (const double x : series.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  panel.series.push_back(
      {label + " " + as_published(*row) + " deep", {low, high}, {height, height}, grey, stroke});
}

void mark_depths(Panel& panel, const TestResult& test, double displacement, const Targets& targets)
{
  mark_depth(panel, test, displacement, targets, "height of peak", "study: largest",
             Stroke::dashed);
  mark_depth(panel, test, displacement, targets, "depth within", "study: within",
             Stroke::dash_dotted);
}

Axis height_axis(const TestResult& test)
{
  return {"height [mm]", false, 0.0, 1e3 * initial_height(test)};
}

/// One column at several displacements.
Panel stages(const TestResult& test, const std::string& name, const Targets& targets)
{
  Panel panel{"Radial displacement, " + name, expansion_axis, height_axis(test), {}};
  double last = 0.0;
  for (const double strain : shown_strains(test)) {
    const double displacement = strain * initial_height(test);
    const auto shape = shape_at(test, displacement);
    if (!shape || strain == 0.0) continue;  // nothing has moved yet
    const std::size_t number = panel.series.size();
    panel.series.push_back({"at " + fixed(1e3 * displacement, 0) + " mm",
                            scaled(shape->radial_displacement, 1e3), scaled(shape->height, 1e3),
                            palette(number), stroke_of_number(number)});
    last = displacement;
  }
  if (!panel.series.empty()) mark_depths(panel, test, last, targets);
  return panel;
}

/// All columns at one displacement, with the largest expansions that the study tells there as lines
/// over the part of the height that it finds them in.
Panel expansion(const Comparison& columns, double displacement, const Targets& targets)
{
  Panel panel{"Radial displacement at " + fixed(1e3 * displacement, 0) + " mm",
              expansion_axis,
              {"height [mm]", false, 0.0, {}},
              {}};
  std::vector<Series> marks;
  const TestResult* first = nullptr;
  const auto depth = column_row(targets, "depth within");
  for (const ColumnCurve& curve : columns.curves) {
    const auto shape = shape_at(*curve.test, displacement);
    if (!shape) continue;
    if (!first) first = curve.test;
    panel.series.push_back({curve.label, scaled(shape->radial_displacement, 1e3),
                            scaled(shape->height, 1e3), curve.color, curve.stroke});
    for (const TargetRow& row : rows_of(curve, targets, "maximum radial expansion")) {
      if (std::abs(*row.words().displacement - displacement) > 1e-6 || !depth) continue;
      const SpecimenShape specimen = specimen_shape(*curve.test);
      const double top = specimen.platens(displacement / specimen.height).top;
      const double low = top - depth->published.model.value_or(0.0) * specimen.diameter;
      marks.push_back({"study, " + curve.label + ": " + as_published(row),
                       {*row.published.model, *row.published.model},
                       {1e3 * low, 1e3 * top},
                       curve.color,
                       Stroke::dashed});
    }
  }
  if (first) panel.y = height_axis(*first);
  panel.series.insert(panel.series.end(), marks.begin(), marks.end());
  if (first) mark_depths(panel, *first, displacement, targets);
  return panel;
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
                    const std::string& pressures, const std::string& expansions,
                    const Targets& targets)
{
  if (columns.curves.empty()) return;
  add(figures, {"column_pressure_" + columns.name,
                "Vertical pressure over displacement, columns " + columns.title,
                "Counterpart of the study's " + pressures +
                    ". It calls this the pressure at the top; its triaxial tests are read at the "
                    "base. Black and coloured discs and the grey line: its numbers.",
                {pressure(columns, "upper", &ShearRecord::stress_top, targets),
                 pressure(columns, "lower", &ShearRecord::stress_bottom, targets)}});
  constexpr double early = 0.012, late = 0.024;  // m, of Figures 17 and 19
  add(figures, {"column_expansion_" + columns.name,
                "Radial displacement along columns " + columns.title,
                "Counterpart of the study's " + expansions +
                    "; straight between the profiles before and after. Grey: how deep below the "
                    "upper platen "
                    "the study finds the largest expansion, and all that is pronounced.",
                {expansion(columns, early, targets), expansion(columns, late, targets)}});
}

std::vector<Figure> column_series_figures_of_set(const std::vector<SetResult>& sets,
                                                 const Targets& targets)
{
  std::vector<Figure> figures;
  if (sets.front().set != "column") return figures;
  const Comparison by_density = densities(sets, targets), by_gradation = gradations(sets, targets);
  add_comparison(figures, by_density, "Figures 11a and 16", "Figure 17", targets);
  add_comparison(figures, by_gradation, "Figure 18", "Figure 19", targets);
  std::vector<Panel> panels;
  const auto labels = test_labels(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t)
      panels.push_back(stages(sets[s].tests[t], labels[s][t], targets));
  add(figures, {"column_profile", "Radial displacement along each column",
                "Counterpart of the study's Figure 11b. Grey: how deep below the upper platen the "
                "study finds the largest expansion, and all that is pronounced.",
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
