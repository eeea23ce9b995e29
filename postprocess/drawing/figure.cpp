// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figure.h"

#include "drawing/canvas.h"
#include "drawing/round_steps.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

constexpr int width = 1200;
constexpr int height_alone = 760;    // of the only panel of a figure
constexpr int height_stacked = 440;  // of each of several

/// How large letters are [px], and whether title and legend are drawn.
struct Look {
  int axis_title, axis_label;
  bool complete;
};
constexpr Look of_a_file{24, 20, true}, of_a_page{18, 16, false};

void add_series(vtkChartXY* chart, const Series& series, bool logarithmic)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName("y");
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (logarithmic && series.y[i] <= 0.0) continue;
    x->InsertNextValue(series.x[i]);
    y->InsertNextValue(series.y[i]);
  }
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(series.label);
  plot->SetLegendVisibility(!series.label.empty());
  plot->SetColor(series.color[0], series.color[1], series.color[2], 255);
  plot->SetWidth(3.0F);
  switch (series.stroke) {
    case Stroke::none:
      plot->GetPen()->SetLineType(vtkPen::NO_PEN);
      break;
    case Stroke::solid:
      plot->GetPen()->SetLineType(vtkPen::SOLID_LINE);
      break;
    case Stroke::dashed:
      plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
      break;
    case Stroke::dash_dotted:
      plot->GetPen()->SetLineType(vtkPen::DASH_DOT_LINE);
      break;
  }
  if (series.marks) {
    auto* points = vtkPlotPoints::SafeDownCast(plot);
    points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    points->SetMarkerSize(14.0F);
  }
}

/// Smallest and largest value to show; curves are never cut, as vector files do not cut them.
std::array<double, 2> range(const Axis& axis, const std::vector<Series>& all,
                            const std::vector<double> Series::*values)
{
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Series& series : all)
    for (const double value : series.*values) {
      if (axis.logarithmic && value <= 0.0) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  // A bound gives way to what lies beyond it, but not to noise around it.
  const double noise = 0.02 * (high - low);
  if (axis.low && low > *axis.low - noise) low = *axis.low;
  const bool bounded = axis.high && high < *axis.high + noise;
  if (bounded) high = *axis.high;
  const double margin = axis.margin * (high - low);
  if (!axis.low) low -= margin;
  if (!axis.high) high += margin;
  if (axis.logarithmic) return {std::floor(std::log10(low)), std::ceil(std::log10(high))};

  const double span = high > low ? high - low : std::max(std::abs(high), 1.0);
  const double step = round_step(span, 10);
  const double rounded = step * std::ceil((low + span) / step - 1e-9);
  return {step * std::floor(low / step + 1e-9), bounded ? high : rounded};
}

void style_axis(vtkAxis* axis, const Axis& given, const std::array<double, 2>& limits,
                const Look& look, bool beside_one_another)
{
  axis->SetTitle(given.title);
  set_font(axis->GetTitleProperties(), look.axis_title);
  set_font(axis->GetLabelProperties(), look.axis_label);
  axis->GetGridPen()->SetColor(225, 225, 225);
  axis->GetPen()->SetWidth(1.5F);
  axis->SetLogScale(given.logarithmic);
  axis->SetGridVisible(!given.logarithmic);  // vector files would show it beyond the range
  axis->SetBehavior(vtkAxis::FIXED);
  if (given.logarithmic)
    axis->SetUnscaledRange(std::pow(10.0, limits[0]), std::pow(10.0, limits[1]));
  else {
    const double margin = 1e-9 * (limits[1] - limits[0]);  // lest rounding lose the last label
    axis->SetRange(limits[0] - margin, limits[1] + margin);
  }
  // Long labels beside one another, as 0.215, run together at the step that VTK takes by itself.
  constexpr double least_step = 0.02;
  const double span = limits[1] - limits[0], step = round_step(span, 10);
  if (beside_one_another && !given.logarithmic && step < least_step)
    axis->SetNumberOfTicks(1 + static_cast<int>(std::lround(span / step)));
  axis->AutoScale();
}

int letters(const std::string& text)
{
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));  // UTF-8
}

/// Letters of a title [px]: smaller where it would run over the labels of the axis, which stand as
/// far apart as the legend leaves room.
int title_size(const Panel& panel)
{
  constexpr int usual = 20, least = 14;                // [px]
  constexpr double of_size = 0.52, of_legend = 10.4;   // mean width of a letter [-], [px]
  constexpr int beside_plot = 110, beside_label = 60;  // labels of the axis; symbols [px]
  int longest = 0;
  for (const Series& series : panel.series) longest = std::max(longest, letters(series.label));
  const double room = width - beside_plot - beside_label - of_legend * longest;
  const double fitting = room / (of_size * std::max(1, letters(panel.title)));
  return std::clamp(static_cast<int>(fitting), least, usual);
}

void add_legend(vtkChartXY* chart)
{
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetInline(false);
  legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend->GetPen()->SetLineType(vtkPen::NO_PEN);
  set_font(legend->GetLabelProperties(), 20);
  legend->SetLabelSize(20);
  legend->SetSymbolWidth(45);
}

void add_panel(vtkContextView* view, const Panel& panel, const vtkRectf& place, const Look& look)
{
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  chart->SetAutoSize(false);
  chart->SetSize(place);
  if (look.complete) chart->SetTitle(panel.title);
  set_font(chart->GetTitleProperties(), title_size(panel));
  for (const Series& series : panel.series) add_series(chart, series, panel.y.logarithmic);
  style_axis(chart->GetAxis(vtkAxis::BOTTOM), panel.x, range(panel.x, panel.series, &Series::x),
             look, true);
  style_axis(chart->GetAxis(vtkAxis::LEFT), panel.y, range(panel.y, panel.series, &Series::y), look,
             false);
  if (look.complete) add_legend(chart);
}

/// An empty view of that size, the same one each time: a new window costs more than a chart, as its
/// shaders are compiled again.
vtkContextView* empty_view(int view_width, int view_height)
{
  static vtkNew<vtkContextView> view;
  view->GetScene()->ClearItems();
  prepare_window(view->GetRenderWindow(), view_width, view_height);
  return view;
}

void draw_figure(const std::filesystem::path& file, const std::vector<Panel>& panels)
{
  const int each = panels.size() == 1 ? height_alone : height_stacked;
  const int height = each * static_cast<int>(panels.size());
  vtkContextView* view = empty_view(width, height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto bottom = static_cast<float>(height - each * (i + 1));
    add_panel(view, panels[i], vtkRectf(10.0F, bottom, width - 20.0F, each - 15.0F), of_a_file);
  }
  write_png(file, view->GetRenderWindow());
  write_svg(file, view->GetRenderWindow());
}

}  // namespace

Color palette(std::size_t i)
{
  static const std::array<Color, palette_size> colors{
      Color{0, 114, 178},  Color{213, 94, 0},  Color{0, 158, 115}, Color{204, 121, 167},
      Color{86, 180, 233}, Color{230, 159, 0}, Color{0, 0, 0}};
  return colors[i % colors.size()];
}

void draw_figures(const std::filesystem::path& folder, const std::vector<Figure>& figures)
{
  for (const Figure& figure : figures) draw_figure(folder / figure.name, figure.panels);
}

std::string chart_svg(const Panel& panel, int height)
{
  vtkContextView* view = empty_view(chart_width, height);
  add_panel(view, panel,
            vtkRectf(5.0F, 5.0F, chart_width - 20.0F, static_cast<float>(height) - 15.0F),
            of_a_page);
  return svg_elements(view->GetRenderWindow());
}

}  // namespace encased_column
