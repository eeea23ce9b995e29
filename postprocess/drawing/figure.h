#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

using Color = std::array<unsigned char, 3>;

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
};

/// One chart: its series over common axes, the legend beside them.
struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// Draws `panels` one above the other into `file`.png and `file`.svg, 1200 px wide. Needs a
/// display. Throws InputError if a file cannot be written.
void draw_figure(const std::filesystem::path& file, const std::vector<Panel>& panels);

}  // namespace encased_column
