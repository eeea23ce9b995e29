// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/column_panels.h"

#include "drawing/labels.h"
#include "tables/target_record.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

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
  for (const TargetRow& row : targets.rows_of("column_gradation", quantity))
    if (row.published.model && row.words().displacement &&
        meets(test_condition(*curve.test), row.words(), {}))
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
      marks.push_back({&curve, row});
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
  if (columns.name == "density")
    mark_column(panel, targets);
  else
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
  if (!panel.series.empty()) mark_depths(panel, test, last, targets);
  return panel;
}

Panel expansion_panel(const Comparison& columns, double displacement, const Targets& targets)
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

}  // namespace encased_column
