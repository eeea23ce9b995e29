// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "drawing/figures.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

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

  /// True if one of them repeats the study, whose numbers may be marked then.
  bool marked() const;
};

/// The row of the study's column that tells `quantity`.
std::optional<TargetRow> column_row(const Targets& targets, const std::string& quantity);

/// Pressure on the "upper" or the "lower" platen of all columns, with the study's numbers.
Panel pressure_panel(const Comparison& columns, const std::string& platen,
                     std::vector<double> ShearRecord::*stress, const Targets& targets);

/// Radial displacement along one column at several displacements of the platens.
Panel stages_panel(const TestResult& test, const std::string& name, const Targets& targets);

/// All columns at one displacement [m], with the depth that the study tells its expansion at: of
/// its column, or of its gradations, whose largest expansions are lines over the part of the height
/// that it finds them in.
Panel expansion_panel(const Comparison& columns, double displacement, const Targets& targets);

}  // namespace encased_column
