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

void aim(vtkRenderer* renderer, double azimuth)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const double tall = bounds[5] - bounds[4];
  const double wide = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const double toward[2] = {std::cos(azimuth * pi / 180.0), std::sin(azimuth * pi / 180.0)};
  const double right[2] = {-toward[1], toward[0]};  // in the picture
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.5 * (bounds[0] + bounds[1]) + 0.18 * wide * right[0],
                        0.5 * (bounds[2] + bounds[3]) + 0.18 * wide * right[1],
                        0.5 * (bounds[4] + bounds[5]));
  const double* focus = camera->GetFocalPoint();
  camera->SetPosition(focus[0] + 10.0 * tall * toward[0], focus[1] + 10.0 * tall * toward[1],
                      focus[2] + 3.0 * tall);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  const double needed = std::max(tall + 0.3 * wide, 1.55 * wide * height / width);
  camera->SetParallelScale(0.5 * 1.12 * needed);
  renderer->ResetCameraClippingRange();
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

void add_color_bar(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title)
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
  bar->SetPosition(0.79, 0.25);
  bar->SetPosition2(0.17, 0.5);
  set_font(bar->GetTitleTextProperty(), 26 * finer);
  set_font(bar->GetLabelTextProperty(), 24 * finer);
  bar->GetTitleTextProperty()->SetJustificationToLeft();
  renderer->AddActor2D(bar);
}

void add_caption(vtkRenderer* renderer, const std::string& caption)
{
  vtkNew<vtkTextActor> text;
  text->SetInput(caption.c_str());
  set_font(text->GetTextProperty(), 28 * finer);
  text->GetTextProperty()->SetJustificationToCentered();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetTextProperty()->SetLineSpacing(1.3);
  text->SetPosition(0.5, 0.98);
  renderer->AddActor2D(text);
}

void draw_scene(const std::filesystem::path& file, vtkRenderer* renderer, double azimuth,
                vtkRenderer* backdrop)
{
  vtkRenderer* const lowest = backdrop ? backdrop : renderer;
  lowest->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  prepare_window(window, finer * width, finer * height);
  window->AddRenderer(lowest);
  aim(lowest, azimuth);
  if (backdrop) {  // a layer above has depths of its own
    window->SetNumberOfLayers(2);
    renderer->SetLayer(1);
    renderer->SetActiveCamera(backdrop->GetActiveCamera());
    window->AddRenderer(renderer);
  }
  write_png(file, window, finer);
}

}  // namespace encased_column
