// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// What a chart shows: a line, dots, or the space between two lines.
struct Mark {
  enum class Kind { line, dashed, dots, band } kind;
  std::string label;  ///< of the legend; empty: not in it
  std::string color;  ///< "#0072b2"
  std::vector<double> x, y;
  std::vector<double> high{};  ///< of a band, whose `y` is the low side
};

/// A chart as an element svg of a page: axes with round steps, marks in their order. Needs no
/// display.
struct ChartAxes {
  std::string title, x, y;  ///< x and y with their units in brackets
};
std::string chart(const ChartAxes& axes, const std::vector<Mark>& marks);

/// Bars from 0 to 1, two a row (alone, and with interactions), with whiskers.
struct BarRow {
  std::string name;
  double first, first_error, total, total_error;
};
std::string bar_chart(const std::string& title, const std::vector<BarRow>& rows);

/// Each column against each other: dots below the diagonal, histograms on it, correlations above.
/// `columns` as shares of the range from 0 to 1; `names` beside them.
std::string pair_plot(const std::vector<std::string>& names,
                      const std::vector<std::vector<double>>& columns,
                      const std::vector<std::vector<double>>& correlations);

}  // namespace encased_column
