// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/contact_bars.h"

#include "drawing/grain_spheres.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace encased_column {

std::vector<ContactBar> contact_bars(const std::filesystem::path& file, double least)
{
  std::vector<ContactBar> bars;
  const vtkSmartPointer<vtkPolyData> contacts = read_poly_data(file);
  if (contacts->GetNumberOfLines() == 0) return bars;
  vtkDataArray* forces = array_of(contacts->GetPointData(), {"force", "N", 1}, file);
  vtkNew<vtkIdList> ends;
  for (vtkIdType line = 0; line < contacts->GetNumberOfLines(); ++line) {
    contacts->GetLines()->GetCellAtId(line, ends);
    const double force = forces->GetTuple1(ends->GetId(0));
    if (force < least) continue;
    ContactBar bar{{}, {}, force};
    contacts->GetPoint(ends->GetId(0), bar.from.data());
    contacts->GetPoint(ends->GetId(1), bar.to.data());
    bars.push_back(bar);
  }
  return bars;
}

vtkSmartPointer<vtkPolyData> sticks_of(const std::vector<ContactBar>& bars, double radius)
{
  vtkNew<vtkPoints> middles;
  vtkNew<vtkDoubleArray> forces;
  vtkNew<vtkFloatArray> directions, sizes;  // the mapper takes no double
  directions->SetName("stick_direction");
  directions->SetNumberOfComponents(3);
  sizes->SetName("stick_size");  // length, radius, and nothing
  sizes->SetNumberOfComponents(3);
  for (const ContactBar& bar : bars) {
    const Vec3 branch = bar.to - bar.from, middle = 0.5 * (bar.from + bar.to);
    middles->InsertNextPoint(middle.data());
    directions->InsertNextTuple(branch.normalized().eval().data());
    sizes->InsertNextTuple3(branch.norm(), radius * bar.force, 0.0);
    forces->InsertNextValue(bar.force);
  }
  auto sticks = vtkSmartPointer<vtkPolyData>::New();
  sticks->SetPoints(middles);
  sticks->GetPointData()->AddArray(directions);
  sticks->GetPointData()->AddArray(sizes);
  sticks->GetPointData()->SetScalars(forces);
  return sticks;
}

void add_sticks(vtkRenderer* renderer, vtkPolyData* sticks, vtkColorTransferFunction* map)
{
  // As with spheres the shader rounds each bar: tubes of facets take minutes without a graphics
  // card.
  add_vertices(sticks);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(sticks);
  mapper->SetOrientationArray("stick_direction");
  mapper->SetScaleArray("stick_size");
  mapper->SetLookupTable(map);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  renderer->AddActor(actor);
}

}  // namespace encased_column
