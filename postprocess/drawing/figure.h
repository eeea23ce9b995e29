// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

using Color = std::array<unsigned char, 3>;

constexpr std::size_t palette_size = 7;

/// Color `i` of Okabe and Ito's palette, told apart with any color vision; repeats after seven.
/// Source: M. Okabe, K. Ito, "Color Universal Design", 2008 (yellow left out: faint on white).
Color palette(std::size_t i);

constexpr Color black{0, 0, 0};
constexpr Color grey{120, 120, 120};

enum class Stroke { none, solid, dashed, dash_dotted };

/// One line of a legend and what it stands for: a curve, points, or both.
struct Series {
  std::string label;  ///< UTF-8; empty: not in the legend
  std::vector<double> x, y;
  Color color;
  Stroke stroke = Stroke::solid;
  bool marks = false;  ///< a disc on each point
};

struct Axis {
  std::string title;  ///< with the unit in brackets
  bool logarithmic = false;
  std::optional<double> low = std::nullopt;   ///< default: what the series need
  std::optional<double> high = std::nullopt;  ///< kept as it is, not rounded to a step
  double margin = 0.0;  ///< beyond the series where no bound is given, as a share of their span
};

/// One chart: its series over common axes, the legend beside them.
struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// Charts that belong together.
struct Figure {
  std::string name;     ///< of its files
  std::string title;    ///< what it shows
  std::string caption;  ///< what a reader must know; may be empty
  std::vector<Panel> panels;
};

/// Draws each figure into `folder`, its panels one above the other in one .png and one .svg file,
/// 1200 px wide. Needs a display. Throws InputError if a file cannot be written.
void draw_figures(const std::filesystem::path& folder, const std::vector<Figure>& figures);

/// The size of chart_svg() in its own units; nothing is drawn above chart_top, where a title would
/// stand.
constexpr int chart_width = 600, chart_height = 420, chart_top = 22;

/// The drawing of `panel` as elements for an SVG of chart_width and `height`: axes and curves
/// in letters large enough for a telephone; title and legend are left to the page around it. Needs
/// a display.
std::string chart_svg(const Panel& panel, int height = chart_height);

}  // namespace encased_column
