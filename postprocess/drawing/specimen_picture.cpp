#include "drawing/specimen_picture.h"

#include "core/input_error.h"
#include "drawing/canvas.h"
#include "drawing/round_steps.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace encased_column {

namespace {

constexpr int width = 1200, height = 1500;
constexpr int finer = 2;       // pixels drawn for each one kept, in both directions
constexpr int bar_parts = 10;  // intervals of the colour bar, at most

vtkDataArray* array_of(vtkPolyData* grains, const std::string& name, int components,
                       const std::filesystem::path& file)
{
  for (const std::string& full : {name, name + " [m]"}) {
    vtkDataArray* array = grains->GetPointData()->GetArray(full.c_str());
    if (array && array->GetNumberOfComponents() == components) return array;
  }
  throw InputError("'" + file.string() + "' must have a point array '" + name + "' of " +
                   std::to_string(components) +
                   " component(s), found none, write the file with the same version");
}

/// Points with the arrays the mapper wants: radius [m] and distance moved [mm].
vtkSmartPointer<vtkPolyData> spheres_of(const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* grains = reader->GetOutput();
  vtkDataArray* radius = array_of(grains, "radius", 1, file);
  vtkDataArray* displacement = array_of(grains, "displacement", 3, file);

  vtkNew<vtkDoubleArray> sphere_radius, moved;
  sphere_radius->SetName("sphere_radius");
  moved->SetName("moved");
  for (vtkIdType i = 0; i < grains->GetNumberOfPoints(); ++i) {
    std::array<double, 3> u{};
    displacement->GetTuple(i, u.data());
    sphere_radius->InsertNextValue(radius->GetTuple1(i));
    moved->InsertNextValue(1e3 * std::hypot(u[0], u[1], u[2]));
  }
  auto spheres = vtkSmartPointer<vtkPolyData>::New();
  spheres->SetPoints(grains->GetPoints());
  spheres->GetPointData()->AddArray(sphere_radius);
  spheres->GetPointData()->SetScalars(moved);
  return spheres;
}

/// Viridis (S. van der Walt and N. Smith, 2015; CC0) at nine places: even steps for every color
/// vision and in grey.
vtkSmartPointer<vtkColorTransferFunction> colors(double highest)
{
  static constexpr double viridis[9][3] = {
      {0.267, 0.005, 0.329}, {0.279, 0.175, 0.483}, {0.230, 0.322, 0.546},
      {0.173, 0.449, 0.558}, {0.128, 0.567, 0.551}, {0.158, 0.684, 0.502},
      {0.369, 0.789, 0.383}, {0.678, 0.864, 0.190}, {0.993, 0.906, 0.144}};
  auto map = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int i = 0; i < 9; ++i)
    map->AddRGBPoint(highest * i / 8.0, viridis[i][0], viridis[i][1], viridis[i][2]);
  return map;
}

/// The distance [mm] that 1 in 200 grains exceeds, rounded up: a few that fell must not hide how
/// all others moved.
double color_limit(vtkPolyData* spheres)
{
  vtkDataArray* moved = spheres->GetPointData()->GetScalars();
  std::vector<double> sorted;
  for (vtkIdType i = 0; i < moved->GetNumberOfTuples(); ++i) sorted.push_back(moved->GetTuple1(i));
  std::sort(sorted.begin(), sorted.end());
  const double limit = sorted[sorted.size() * 199 / 200];
  if (!(limit > 0.0)) return 1.0;
  const double step = round_step(limit, bar_parts);
  return step * std::ceil(limit / step - 1e-9);
}

void add_spheres(vtkRenderer* renderer, vtkPolyData* spheres, vtkColorTransferFunction* map)
{
  // Small in the picture where there are many: coarser spheres look the same and draw faster.
  const int parts = spheres->GetNumberOfPoints() < 20000 ? 12 : 8;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetPhiResolution(parts);
  sphere->SetThetaResolution(2 * parts);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(spheres);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  mapper->SetScaleArray("sphere_radius");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetLookupTable(map);
  mapper->SetColorModeToMapScalars();
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(20.0);
  renderer->AddActor(actor);
}

void add_text(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& caption)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(map);
  bar->SetTitle("displacement [mm]\n ");
  const double highest = map->GetRange()[1];
  bar->SetNumberOfLabels(1 +
                         static_cast<int>(std::lround(highest / round_step(highest, bar_parts))));
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

  vtkNew<vtkTextActor> text;
  text->SetInput(caption.c_str());
  set_font(text->GetTextProperty(), 28 * finer);
  text->GetTextProperty()->SetJustificationToCentered();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.5, 0.955);
  renderer->AddActor2D(text);
}

/// From the side and a little above; the specimen left of the middle, where the bar leaves room.
void aim(vtkRenderer* renderer, const double* bounds)
{
  const double tall = bounds[5] - bounds[4];
  const double wide = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.5 * (bounds[0] + bounds[1]) + 0.18 * wide, 0.5 * (bounds[2] + bounds[3]),
                        0.5 * (bounds[4] + bounds[5]));
  const double* focus = camera->GetFocalPoint();
  camera->SetPosition(focus[0], focus[1] - 10.0 * tall, focus[2] + 3.0 * tall);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  const double needed = std::max(tall + 0.3 * wide, 1.55 * wide * height / width);
  camera->SetParallelScale(0.5 * 1.12 * needed);
  renderer->ResetCameraClippingRange();
}

}  // namespace

void draw_specimen(const std::filesystem::path& file, const std::filesystem::path& grains,
                   const std::string& caption)
{
  const vtkSmartPointer<vtkPolyData> spheres = spheres_of(grains);
  const auto map = colors(color_limit(spheres));

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  add_spheres(renderer, spheres, map);
  add_text(renderer, map, caption);

  vtkNew<vtkRenderWindow> window;
  prepare_window(window, finer * width, finer * height);
  window->AddRenderer(renderer);
  aim(renderer, spheres->GetBounds());
  write_png(file, window, finer);
}

}  // namespace encased_column
