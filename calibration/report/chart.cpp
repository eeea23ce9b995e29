// SPDX-License-Identifier: GPL-2.0-only
#include "report/chart.h"

#include "drawing/round_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace encased_column {

namespace {

constexpr double width = 560, height = 360, left = 70, right = 15, top = 15, bottom = 50;

std::string number(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string pixel(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  return text;
}

std::string escaped(const std::string& text)
{
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string text_at(double x, double y, const char* anchor, const std::string& words, int size = 14,
                    const std::string& more = "")
{
  return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" text-anchor=\"" + anchor +
         "\" font-size=\"" + std::to_string(size) + "\" fill=\"currentColor\"" + more + ">" +
         escaped(words) + "</text>";
}

std::string line_at(double x1, double y1, double x2, double y2, const std::string& color)
{
  return "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) + "\" y2=\"" +
         pixel(y2) + "\" stroke=\"" + color + "\"/>";
}

std::string opening(double w, double h, const std::string& title)
{
  return "<svg viewBox=\"0 0 " + pixel(w) + " " + pixel(h) + "\" role=\"img\" aria-label=\"" +
         escaped(title) + "\" font-family=\"sans-serif\">";
}

/// One axis: from data to pixels.
struct Scale {
  double low, high, from, to;
  double at(double value) const { return from + (value - low) / (high - low) * (to - from); }
};

Scale scale_of(std::vector<double> values, double from, double to)
{
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
      values.end());
  double low = 0.0, high = 1.0;
  if (!values.empty()) {
    low = *std::min_element(values.begin(), values.end());
    high = *std::max_element(values.begin(), values.end());
    if (low > 0.0 && low < 0.4 * high) low = 0.0;
    if (!(high > low)) high = low + std::max(std::abs(low), 1.0);
    const RoundRange round = round_range(low, high, 8);
    low = round.low;
    high = round.high;
  }
  return {low, high, from, to};
}

std::string points(const Scale& x, const Scale& y, const std::vector<double>& xs,
                   const std::vector<double>& ys, bool reversed = false)
{
  std::string text;
  for (std::size_t n = 0; n < xs.size(); ++n) {
    const std::size_t i = reversed ? xs.size() - 1 - n : n;
    if (std::isfinite(ys[i])) text += pixel(x.at(xs[i])) + "," + pixel(y.at(ys[i])) + " ";
  }
  return text;
}

std::string drawn(const Mark& mark, const Scale& x, const Scale& y)
{
  if (mark.kind == Mark::Kind::band)
    return "<polygon points=\"" + points(x, y, mark.x, mark.y) +
           points(x, y, mark.x, mark.high, true) + "\" fill=\"" + mark.color +
           "\" fill-opacity=\"0.2\"/>";
  std::string text;
  if (mark.kind == Mark::Kind::dots) {
    for (std::size_t n = 0; n < mark.x.size(); ++n)
      text += "<circle cx=\"" + pixel(x.at(mark.x[n])) + "\" cy=\"" + pixel(y.at(mark.y[n])) +
              "\" r=\"3\" fill=\"" + mark.color + "\" fill-opacity=\"0.7\"/>";
    return text;
  }
  return "<polyline points=\"" + points(x, y, mark.x, mark.y) + "\" fill=\"none\" stroke=\"" +
         mark.color + "\" stroke-width=\"2\"" +
         (mark.kind == Mark::Kind::dashed ? " stroke-dasharray=\"7 4\"" : "") + "/>";
}

std::string axes_drawn(const ChartAxes& axes, const Scale& x, const Scale& y)
{
  std::string text;
  const double step_x = round_step(x.high - x.low, 8), step_y = round_step(y.high - y.low, 8);
  for (double v = x.low; v <= x.high + 1e-9 * step_x; v += step_x)
    text += line_at(x.at(v), top, x.at(v), height - bottom, "#8884") +
            text_at(x.at(v), height - bottom + 18, "middle",
                    number(std::abs(v) < 1e-9 * step_x ? 0 : v));
  for (double v = y.low; v <= y.high + 1e-9 * step_y; v += step_y)
    text += line_at(left, y.at(v), width - right, y.at(v), "#8884") +
            text_at(left - 6, y.at(v) + 5, "end", number(std::abs(v) < 1e-9 * step_y ? 0 : v));
  text += text_at(0.5 * (left + width - right), height - 8, "middle", axes.x);
  return text +
         text_at(16, 0.5 * (top + height - bottom), "middle", axes.y, 14,
                 " transform=\"rotate(-90 16 " + pixel(0.5 * (top + height - bottom)) + ")\"");
}

}  // namespace

std::string chart(const ChartAxes& axes, const std::vector<Mark>& marks)
{
  std::vector<double> xs, ys;
  for (const Mark& mark : marks) {
    xs.insert(xs.end(), mark.x.begin(), mark.x.end());
    ys.insert(ys.end(), mark.y.begin(), mark.y.end());
    ys.insert(ys.end(), mark.high.begin(), mark.high.end());
  }
  const Scale x = scale_of(xs, left, width - right), y = scale_of(ys, height - bottom, top);
  std::string text = opening(width, height, axes.title + ": " + axes.y + " over " + axes.x) +
                     axes_drawn(axes, x, y);
  for (const Mark& mark : marks) text += drawn(mark, x, y);
  text += "</svg><ul class=\"legend\">";
  for (const Mark& mark : marks)
    if (!mark.label.empty())
      text += "<li><svg viewBox=\"0 0 34 10\" aria-hidden=\"true\">" +
              drawn({mark.kind == Mark::Kind::dots ? Mark::Kind::dots : mark.kind,
                     "",
                     mark.color,
                     mark.kind == Mark::Kind::dots ? std::vector<double>{17}
                                                   : std::vector<double>{1, 33},
                     mark.kind == Mark::Kind::band   ? std::vector<double>{1, 1}
                     : mark.kind == Mark::Kind::dots ? std::vector<double>{5}
                                                     : std::vector<double>{5, 5},
                     {9, 9}},
                    {0, 1, 0, 1}, {0, 1, 0, 1}) +
              "</svg>" + escaped(mark.label) + "</li>";
  return text + "</ul>";
}

std::string bar_chart(const std::string& title, const std::vector<BarRow>& rows)
{
  constexpr double row_height = 34, names = 130, long_bar = 380;
  const double h = 30 + row_height * static_cast<double>(rows.size());
  std::string text = opening(width, h, title);
  for (const double v : {0.0, 0.25, 0.5, 0.75, 1.0})
    text += line_at(names + long_bar * v, 0, names + long_bar * v, h - 22, "#8884") +
            text_at(names + long_bar * v, h - 6, "middle", number(v), 13);
  const auto bar = [&](double y, double value, double error, const char* color) {
    const double shown = std::clamp(value, 0.0, 1.0), end = names + long_bar * shown;
    const double low = names + long_bar * std::clamp(value - error, 0.0, 1.0),
                 high = names + long_bar * std::clamp(value + error, 0.0, 1.0);
    text += "<rect x=\"" + pixel(names) + "\" y=\"" + pixel(y) + "\" width=\"" +
            pixel(end - names) + "\" height=\"11\" fill=\"" + color + "\"/>" +
            line_at(low, y + 5.5, high, y + 5.5, "currentColor");
  };
  double y = 4;
  for (const BarRow& row : rows) {
    text += text_at(names - 8, y + 16, "end", row.name);
    bar(y, row.first, row.first_error, "#0072b2");
    bar(y + 12, row.total, row.total_error, "#e69f00");
    y += row_height;
  }
  return text + "</svg>";
}

std::string pair_plot(const std::vector<std::string>& names,
                      const std::vector<std::vector<double>>& columns,
                      const std::vector<std::vector<double>>& correlations)
{
  constexpr double cell = 120, gap = 8, margin = 30;
  constexpr std::size_t bins = 20, most_dots = 400;
  const double size = margin + static_cast<double>(names.size()) * (cell + gap);
  std::string text = "<div style=\"max-width: " + pixel(1.1 * size) + "px\">" +
                     opening(size, size - margin, "Parameters against one another");
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < names.size(); ++j) {
      const double x0 = margin + static_cast<double>(j) * (cell + gap),
                   y0 = static_cast<double>(i) * (cell + gap);
      text += "<rect x=\"" + pixel(x0) + "\" y=\"" + pixel(y0) + "\" width=\"" + pixel(cell) +
              "\" height=\"" + pixel(cell) + "\" fill=\"none\" stroke=\"#888\"/>";
      if (i == j) {
        std::vector<double> counts(bins, 0.0);
        for (const double v : columns[i])
          counts[std::min(bins - 1, static_cast<std::size_t>(std::max(v, 0.0) * bins))] += 1.0;
        const double most = *std::max_element(counts.begin(), counts.end());
        for (std::size_t b = 0; b < bins; ++b) {
          const double tall = most > 0.0 ? 0.8 * cell * counts[b] / most : 0.0;
          text += "<rect x=\"" + pixel(x0 + cell * static_cast<double>(b) / bins) + "\" y=\"" +
                  pixel(y0 + cell - tall) + "\" width=\"" + pixel(cell / bins) + "\" height=\"" +
                  pixel(tall) + "\" fill=\"#0072b2\"/>";
        }
        text += text_at(x0 + 0.5 * cell, y0 + 16, "middle", names[i]);
      } else if (j < i) {
        const std::size_t every = std::max<std::size_t>(1, columns[i].size() / most_dots);
        for (std::size_t n = 0; n < columns[i].size(); n += every)
          text += "<circle cx=\"" + pixel(x0 + cell * columns[j][n]) + "\" cy=\"" +
                  pixel(y0 + cell * (1.0 - columns[i][n])) +
                  "\" r=\"1.5\" fill=\"#0072b2\" fill-opacity=\"0.5\"/>";
      } else {
        char word[16];
        std::snprintf(word, sizeof word, "%.2f", correlations[i][j]);
        text += "<rect x=\"" + pixel(x0) + "\" y=\"" + pixel(y0) + "\" width=\"" + pixel(cell) +
                "\" height=\"" + pixel(cell) + "\" fill=\"#e69f00\" fill-opacity=\"" +
                pixel(std::abs(correlations[i][j])) + "\"/>" +
                text_at(x0 + 0.5 * cell, y0 + 0.55 * cell, "middle", word, 18);
      }
    }
  return text + "</svg></div>";
}

}  // namespace encased_column
