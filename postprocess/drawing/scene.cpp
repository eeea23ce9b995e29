// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/scene.h"

#include "core/constants.h"
#include "drawing/canvas.h"
#include "drawing/round_steps.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

namespace {

constexpr int width = 1200, height = 1500;
int finer = 2;                 // pixels drawn for each one kept, in both directions
constexpr int bar_parts = 10;  // intervals of the colour bar, at most

/// A window of `across` x `high` pixels kept. Where finer ones are drawn, samples within these
/// would smooth the edges of letters and facets twice, and spheres not at all, at three times the
/// cost.
vtkSmartPointer<vtkRenderWindow> window_of(int across, int high)
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  constexpr int usual_samples = 8;
  prepare_window(window, finer * across, finer * high, finer > 1 ? 0 : usual_samples);
  return window;
}

/// What a renderer holds [m].
struct Extent {
  double center[3];
  double tall, wide;
  /// As high as it is seen, from a little above.
  double seen() const { return tall + 0.3 * wide; }
};

Extent extent_of(vtkRenderer* renderer)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  return {
      {0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5])},
      bounds[5] - bounds[4],
      std::max(bounds[1] - bounds[0], bounds[3] - bounds[2])};
}

/// Aims at `extent`, `aside` of its widths right of its middle; the picture is `needed` [m] high.
void aim(vtkRenderer* renderer, double azimuth, const Extent& extent, double aside, double needed)
{
  const double toward[2] = {std::cos(azimuth * pi / 180.0), std::sin(azimuth * pi / 180.0)};
  const double right[2] = {-toward[1], toward[0]};  // in the picture
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(extent.center[0] + aside * extent.wide * right[0],
                        extent.center[1] + aside * extent.wide * right[1], extent.center[2]);
  const double* focus = camera->GetFocalPoint();
  camera->SetPosition(focus[0] + 10.0 * extent.tall * toward[0],
                      focus[1] + 10.0 * extent.tall * toward[1], focus[2] + 3.0 * extent.tall);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * needed);
  renderer->ResetCameraClippingRange();
}

/// Lays `front` over `back`, with depths of its own.
void add_layers(vtkRenderWindow* window, vtkRenderer* back, vtkRenderer* front)
{
  back->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(back);
  if (!front) return;
  window->SetNumberOfLayers(2);
  front->SetLayer(1);
  front->SetActiveCamera(back->GetActiveCamera());
  window->AddRenderer(front);
}

}  // namespace

// S. van der Walt and N. Smith, 2015; CC0. At nine places: even steps for every color vision and
// in grey.
vtkSmartPointer<vtkColorTransferFunction> viridis(double low, double high)
{
  static constexpr double colors[9][3] = {
      {0.267, 0.005, 0.329}, {0.279, 0.175, 0.483}, {0.230, 0.322, 0.546},
      {0.173, 0.449, 0.558}, {0.128, 0.567, 0.551}, {0.158, 0.684, 0.502},
      {0.369, 0.789, 0.383}, {0.678, 0.864, 0.190}, {0.993, 0.906, 0.144}};
  auto map = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int i = 0; i < 9; ++i)
    map->AddRGBPoint(low + (high - low) * i / 8.0, colors[i][0], colors[i][1], colors[i][2]);
  return map;
}

vtkSmartPointer<vtkColorTransferFunction> colors_for(vtkDataArray* values)
{
  std::vector<double> sorted;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    sorted.push_back(values->GetTuple1(i));
  std::sort(sorted.begin(), sorted.end());
  double low = std::min(0.0, sorted[sorted.size() / 200]);
  const double high = std::max(0.0, sorted[sorted.size() * 199 / 200]);
  if (low > -0.05 * high) low = 0.0;
  if (!(high > low)) return viridis(0.0, 1.0);
  const RoundRange range = round_range(low, high, bar_parts);
  return viridis(range.low, range.high);
}

void draw_drafts()
{
  finer = 1;
}

namespace {

/// The bar from the place `left` of its renderer on, `wide`, as shares of its width.
void add_color_bar(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title,
                   double left, double wide)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(map);
  bar->SetTitle((title + "\n ").c_str());
  const double span = map->GetRange()[1] - map->GetRange()[0];
  bar->SetNumberOfLabels(1 + static_cast<int>(std::lround(span / round_step(span, bar_parts))));
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  bar->SetBarRatio(0.3);
  bar->SetMaximumNumberOfColors(256);
  bar->SetTextPad(6 * finer);
  bar->SetPosition(left, 0.25);
  bar->SetPosition2(wide, 0.5);
  set_font(bar->GetTitleTextProperty(), 26 * finer);
  set_font(bar->GetLabelTextProperty(), 24 * finer);
  bar->GetTitleTextProperty()->SetJustificationToLeft();
  renderer->AddActor2D(bar);
}

}  // namespace

void add_color_bar(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title)
{
  add_color_bar(renderer, map, title, 0.79, 0.17);
}

namespace {

/// Lines from the height `upper` of its renderer down, as a share of it.
void add_caption(vtkRenderer* renderer, const std::string& caption, double upper)
{
  vtkNew<vtkTextActor> text;
  text->SetInput(caption.c_str());
  set_font(text->GetTextProperty(), 28 * finer);
  text->GetTextProperty()->SetJustificationToCentered();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetTextProperty()->SetLineSpacing(1.3);
  text->SetPosition(0.5, upper);
  renderer->AddActor2D(text);
}

}  // namespace

void add_caption(vtkRenderer* renderer, const std::string& caption)
{
  add_caption(renderer, caption, 0.98);
}

void draw_scene(const std::filesystem::path& file, vtkRenderer* renderer, double azimuth,
                vtkRenderer* backdrop)
{
  vtkRenderer* const lowest = backdrop ? backdrop : renderer;
  const vtkSmartPointer<vtkRenderWindow> window = window_of(width, height);
  add_layers(window, lowest, backdrop ? renderer : nullptr);
  const Extent extent = extent_of(lowest);
  const double needed = std::max(extent.seen(), 1.55 * extent.wide * height / width);
  aim(lowest, azimuth, extent, 0.18, 1.12 * needed);
  write_png(file, window, finer);
}

void draw_scenes(const std::filesystem::path& file, const std::vector<SceneView>& views,
                 double azimuth, const std::string& caption, vtkColorTransferFunction* map,
                 const std::string& title)
{
  constexpr int all_wide = 1500, bar_wide = 230, least_high = 700, most_high = 1300;  // px
  constexpr int heading = 70, labels = 80;  // px above the views and in each above its bodies
  const int view_wide = (all_wide - bar_wide) / static_cast<int>(views.size());
  Extent extent = extent_of(views.front().backdrop);
  for (const SceneView& view : views) {
    const Extent other = extent_of(view.backdrop);
    extent.tall = std::max(extent.tall, other.tall);
    extent.wide = std::max(extent.wide, other.wide);
  }
  const double across = 1.15 * extent.wide;  // m, seen in a view at least
  const int high = std::clamp(static_cast<int>(1.06 * extent.seen() * view_wide / across) + labels,
                              least_high, most_high);
  const double upper = static_cast<double>(high) / (high + heading);
  const double needed =
      std::max(1.06 * extent.seen() * high / (high - labels), across * high / view_wide);

  const vtkSmartPointer<vtkRenderWindow> window = window_of(all_wide, high + heading);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double left = static_cast<double>(i) * view_wide / all_wide;
    const double right = left + static_cast<double>(view_wide) / all_wide;
    add_layers(window, views[i].backdrop, views[i].renderer);
    for (vtkRenderer* renderer : {views[i].backdrop, views[i].renderer})
      renderer->SetViewport(left, 0.0, right, upper);
    add_caption(views[i].renderer, views[i].label);
    aim(views[i].backdrop, azimuth, extent, 0.0, needed);
    // Down, for the label above.
    vtkCamera* camera = views[i].backdrop->GetActiveCamera();
    camera->SetWindowCenter(0.0, static_cast<double>(labels) / high);
  }
  vtkNew<vtkRenderer> beside, above;
  beside->SetBackground(1.0, 1.0, 1.0);
  const double end = static_cast<double>(views.size()) * view_wide / all_wide;
  beside->SetViewport(end, 0.0, 1.0, upper);
  add_color_bar(beside, map, title, 0.05, 0.9);
  above->SetBackground(1.0, 1.0, 1.0);
  above->SetViewport(0.0, upper, 1.0, 1.0);
  add_caption(above, caption, 0.75);
  window->AddRenderer(beside);
  window->AddRenderer(above);
  write_png(file, window, finer);
}

}  // namespace encased_column
