// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/column_panels.h"

#include "drawing/labels.h"
#include "tables/target_record.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace encased_column {

bool Comparison::marked() const
{
  return std::any_of(curves.begin(), curves.end(),
                     [](const ColumnCurve& curve) { return repeats_study(*curve.test); });
}

std::optional<TargetRow> column_row(const Targets& targets, const std::string& quantity)
{
  const std::vector<TargetRow> rows = targets.rows_of("column", quantity);
  return rows.empty() ? std::nullopt : std::optional(rows.front());
}

namespace {

const Axis displacement_axis{"vertical displacement [mm]", false, 0.0, {}};
const Axis expansion_axis{"radial displacement [mm], expansion positive", false, {}, {}};

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
  if (!repeats_study(*curve.test)) return rows;
  for (const TargetRow& row : targets.rows_of("column_gradation", quantity))
    if (row.published.model && meets(test_condition(*curve.test), row.words(), {}))
      rows.push_back(row);
  return rows;
}

/// The study's pressures lie closer to one another than a disc is high: each is a bar of its own
/// width, side by side about the displacement they are told for.
void mark_gradations(Panel& panel, const ColumnCurves& curves, const Targets& targets)
{
  struct Mark {
    const ColumnCurve* curve;
    TargetRow row;
  };
  std::vector<Mark> marks;
  for (const ColumnCurve& curve : curves)
    for (const TargetRow& row : rows_of(curve, targets, "vertical pressure"))
      if (row.words().displacement) marks.push_back({&curve, row});
  const double width = 0.04 * largest_x(panel);  // mm
  double left = -0.5 * width * static_cast<double>(marks.size());
  for (const Mark& mark : marks) {
    const double at = 1e3 * *mark.row.words().displacement + left;
    const double value = *mark.row.published.model;
    panel.series.push_back({"study, " + mark.curve->label + ": " + as_published(mark.row),
                            {at, at + width},
                            {value, value},
                            mark.curve->color});
    left += width;
  }
}

}  // namespace

Panel pressure_panel(const Comparison& columns, const std::string& platen,
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
  if (columns.name == "density" && columns.marked())
    mark_column(panel, targets);
  else if (columns.name != "density")
    mark_gradations(panel, columns.curves, targets);
  return panel;
}

namespace {

/// The sleeve between the platens where these have come closer by `displacement` [m].
std::optional<SleeveProfile> shape_at(const TestResult& test, double displacement)
{
  const double strain = displacement / initial_height(test);
  const std::optional<SleeveProfile> profile = profile_at(test.profiles, strain);
  if (!profile) return std::nullopt;
  const SleeveProfile inside = between_platens(*profile, specimen_shape(test).platens(strain));
  return inside.height.empty() ? std::nullopt : std::optional(inside);
}

/// A line across `panel` that is `depth` diameters below the upper platen.
void mark_depth(Panel& panel, const TestResult& test, double displacement, double depth,
                const std::string& label, Stroke stroke)
{
  const SpecimenShape shape = specimen_shape(test);
  const double top = shape.platens(displacement / shape.height).top;
  const double height = 1e3 * (top - depth * shape.diameter);
  double low = 0.0, high = 0.0;
  for (const Series& series : panel.series)
    for (const double x : series.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  panel.series.push_back({label, {low, high}, {height, height}, grey, stroke});
}

/// What the study says of its column (section 3.1).
void mark_depths(Panel& panel, const TestResult& test, double displacement, const Targets& targets)
{
  for (const auto& [quantity, label, stroke] :
       {std::tuple("height of peak", "study: largest ", Stroke::dashed),
        std::tuple("depth within", "study: within ", Stroke::dash_dotted)}) {
    const auto row = column_row(targets, quantity);
    if (row && row->published.model)
      mark_depth(panel, test, displacement, *row->published.model,
                 label + as_published(*row) + " deep", stroke);
  }
}

/// Between which depths [diameters] the study finds the expansion of its gradations pronounced
/// (section 4.2); nothing for a curve of none of them.
std::optional<std::pair<double, double>> pronounced_depths(const ColumnCurve& curve,
                                                           const Targets& targets)
{
  for (const TargetRow& row : rows_of(curve, targets, "depth of the pronounced expansion"))
    if (row.words().range) return row.words().range;
  return std::nullopt;
}

Axis height_axis(const TestResult& test)
{
  return {"height [mm]", false, 0.0, 1e3 * initial_height(test)};
}

}  // namespace

Panel stages_panel(const TestResult& test, const std::string& name, const Targets& targets)
{
  Panel panel{"Radial displacement, " + name, expansion_axis, height_axis(test), {}};
  double last = 0.0;
  for (const double wanted : shown_strains(test)) {
    // The last profile may stand a part of a frame before the end.
    const double strain =
        test.profiles.empty() ? 0.0 : std::min(wanted, test.profiles.back().axial_strain);
    const double displacement = strain * initial_height(test);
    const auto shape = shape_at(test, displacement);
    if (!shape || strain == 0.0) continue;  // nothing has moved yet
    const std::size_t number = panel.series.size();
    panel.series.push_back({"at " + fixed(1e3 * displacement, 0) + " mm",
                            scaled(shape->radial_displacement, 1e3), scaled(shape->height, 1e3),
                            palette(number), stroke_of_number(number)});
    last = displacement;
  }
  if (!panel.series.empty() && repeats_study(test)) mark_depths(panel, test, last, targets);
  return panel;
}

namespace {

/// The study's largest expansions of `curve` at `displacement` [m], over the depths it finds them
/// in.
std::vector<Series> largest_expansions(const ColumnCurve& curve, double displacement,
                                       const Targets& targets)
{
  std::vector<Series> marks;
  const auto depths = pronounced_depths(curve, targets);
  if (!depths) return marks;
  const SpecimenShape specimen = specimen_shape(*curve.test);
  const double top = specimen.platens(displacement / specimen.height).top;
  for (const TargetRow& row : rows_of(curve, targets, "maximum radial expansion")) {
    const auto at = row.words().displacement;
    if (!at || std::abs(*at - displacement) > 1e-6) continue;
    marks.push_back({"study, " + curve.label + ": " + as_published(row),
                     {*row.published.model, *row.published.model},
                     {1e3 * (top - depths->second * specimen.diameter),
                      1e3 * (top - depths->first * specimen.diameter)},
                     curve.color,
                     Stroke::dashed});
  }
  return marks;
}

}  // namespace

Panel expansion_panel(const Comparison& columns, double displacement, const Targets& targets)
{
  Panel panel{"Radial displacement at " + fixed(1e3 * displacement, 0) + " mm",
              expansion_axis,
              {"height [mm]", false, 0.0, {}},
              {}};
  std::vector<Series> marks;
  const TestResult* first = nullptr;
  std::optional<std::pair<double, double>> pronounced;
  for (const ColumnCurve& curve : columns.curves) {
    const auto shape = shape_at(*curve.test, displacement);
    if (!shape) continue;
    if (!first) first = curve.test;
    panel.series.push_back({curve.label, scaled(shape->radial_displacement, 1e3),
                            scaled(shape->height, 1e3), curve.color, curve.stroke});
    if (columns.name != "gradation") continue;
    if (!pronounced) pronounced = pronounced_depths(curve, targets);
    for (Series& mark : largest_expansions(curve, displacement, targets))
      marks.push_back(std::move(mark));
  }
  if (!first) return panel;
  panel.y = height_axis(*first);
  panel.series.insert(panel.series.end(), marks.begin(), marks.end());
  if (columns.name != "gradation" && columns.marked())
    mark_depths(panel, *first, displacement, targets);
  if (pronounced)
    for (const double depth : {pronounced->first, pronounced->second})
      mark_depth(panel, *first, displacement, depth,
                 "study: pronounced " + std::string(depth > pronounced->first ? "to " : "from ") +
                     in_words(depth) + " D deep",
                 depth > pronounced->first ? Stroke::dash_dotted : Stroke::dashed);
  return panel;
}

}  // namespace encased_column
