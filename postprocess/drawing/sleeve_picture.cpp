// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "core/input_error.h"
#include "drawing/grain_spheres.h"
#include "drawing/scene.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkImplicitBoolean.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace encased_column {

namespace {

constexpr double from_azimuth = -75.0;  // deg: both faces of the cut and the left side are seen

/// The quarter x > axis, y < axis that is cut out.
struct Quarter {
  double x, y;  ///< of the axis [m]
  bool holds(const double* point) const { return point[0] > x && point[1] < y; }
};

/// The sleeve with its hoop tension [kN/m] as scalars of the facets.
vtkSmartPointer<vtkPolyData> sleeve_of(const std::filesystem::path& file)
{
  const vtkSmartPointer<vtkPolyData> sleeve = read_poly_data(file);
  if (sleeve->GetNumberOfCells() == 0)
    throw InputError("'" + file.string() +
                     "' must hold the facets of a sleeve, found none, run the case again");
  vtkDataArray* tension = array_of(sleeve->GetCellData(), {"hoop_tension", "N/m", 1}, file);
  vtkNew<vtkDoubleArray> kilo;
  kilo->SetName("hoop tension");
  for (vtkIdType i = 0; i < tension->GetNumberOfTuples(); ++i)
    kilo->InsertNextValue(tension->GetTuple1(i) / 1e3);
  sleeve->GetCellData()->SetScalars(kilo);
  return sleeve;
}

void add_sleeve(vtkRenderer* renderer, vtkPolyData* sleeve, const Quarter& quarter,
                vtkColorTransferFunction* map)
{
  vtkNew<vtkPolyDataNormals> smooth;  // of the whole: the cut must not bend them
  smooth->SetInputData(sleeve);
  smooth->SplittingOff();
  vtkNew<vtkPlane> along_y, along_x;  // negative inside the quarter
  along_y->SetOrigin(quarter.x, quarter.y, 0.0);
  along_y->SetNormal(-1.0, 0.0, 0.0);
  along_x->SetOrigin(quarter.x, quarter.y, 0.0);
  along_x->SetNormal(0.0, 1.0, 0.0);
  vtkNew<vtkImplicitBoolean> cut;
  cut->SetOperationTypeToIntersection();
  cut->AddFunction(along_y);
  cut->AddFunction(along_x);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputConnection(smooth->GetOutputPort());
  clip->SetClipFunction(cut);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(clip->GetOutputPort());
  mapper->SetScalarModeToUseCellData();
  mapper->SetLookupTable(map);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.5);
  actor->GetProperty()->SetDiffuse(0.5);
  renderer->AddActor(actor);
}

}  // namespace

void draw_sleeve(const std::filesystem::path& file, const FrameWithGrains& frame,
                 const std::string& caption)
{
  const vtkSmartPointer<vtkPolyData> sleeve = sleeve_of(frame.file);
  const auto map = colors_for(sleeve->GetCellData()->GetScalars());
  const double* bounds = sleeve->GetBounds();
  const Quarter quarter{0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3])};

  vtkNew<vtkRenderer> renderer;
  add_sleeve(renderer, sleeve, quarter, map);
  const vtkSmartPointer<vtkPolyData> grains = grain_spheres(frame.grains);
  const auto outside = [&](vtkIdType i) { return !quarter.holds(grains->GetPoint(i)); };
  add_spheres(renderer, spheres_where(grains, outside), nullptr);
  add_color_bar(renderer, map, "hoop tension [kN/m]");
  add_caption(renderer, caption);
  draw_scene(file, renderer, from_azimuth);
}

}  // namespace encased_column
