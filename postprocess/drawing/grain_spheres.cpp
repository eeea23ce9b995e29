// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/grain_spheres.h"

#include "core/input_error.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkXMLPolyDataReader.h>

namespace encased_column {

namespace {

/// Each sphere is one square that the shader rounds: no facets, and fast without a graphics card.
vtkSmartPointer<vtkActor> actor_of(vtkPolyData* spheres, vtkColorTransferFunction* map)
{
  add_vertices(spheres);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(spheres);
  mapper->SetScaleArray("sphere_radius");
  if (map) {
    mapper->SetLookupTable(map);
    mapper->SetColorModeToMapScalars();
    mapper->UseLookupTableScalarRangeOn();
  } else
    mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

void add_vertices(vtkPolyData* points)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) vertices->InsertNextCell(1, &i);
  points->SetVerts(vertices);
}

vtkDataArray* find_array(vtkDataSetAttributes* arrays, const ArrayName& called)
{
  for (const std::string& name : {called.name, called.name + " [" + called.unit + "]"}) {
    vtkDataArray* array = arrays->GetArray(name.c_str());
    if (array && array->GetNumberOfComponents() == called.components) return array;
  }
  return nullptr;
}

vtkDataArray* array_of(vtkDataSetAttributes* arrays, const ArrayName& called,
                       const std::filesystem::path& file)
{
  if (vtkDataArray* array = find_array(arrays, called)) return array;
  throw InputError("'" + file.string() + "' must have an array '" + called.name + "' of " +
                   std::to_string(called.components) +
                   " component(s), found none, write the file with the same version");
}

vtkSmartPointer<vtkPolyData> grain_spheres(const std::filesystem::path& file)
{
  vtkSmartPointer<vtkPolyData> grains = read_poly_data(file);
  vtkDataArray* radius = array_of(grains->GetPointData(), {"radius", "m", 1}, file);
  vtkNew<vtkFloatArray> sphere_radius;  // the mapper takes no double
  sphere_radius->SetName("sphere_radius");
  for (vtkIdType i = 0; i < grains->GetNumberOfPoints(); ++i)
    sphere_radius->InsertNextValue(static_cast<float>(radius->GetTuple1(i)));
  grains->GetPointData()->AddArray(sphere_radius);
  return grains;
}

void color_by(vtkPolyData* spheres, vtkDataArray* values, double factor)
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("color");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) {
    const double* value = values->GetTuple(i);
    const bool vector = values->GetNumberOfComponents() == 3;
    scalars->InsertNextValue(factor * (vector ? vtkMath::Norm(value) : *value));
  }
  spheres->GetPointData()->SetScalars(scalars);
}

vtkSmartPointer<vtkPolyData> spheres_where(vtkPolyData* spheres,
                                           const std::function<bool(vtkIdType)>& chosen)
{
  vtkNew<vtkPoints> points;
  auto left = vtkSmartPointer<vtkPolyData>::New();
  left->GetPointData()->CopyAllocate(spheres->GetPointData());
  for (vtkIdType i = 0; i < spheres->GetNumberOfPoints(); ++i)
    if (chosen(i))
      left->GetPointData()->CopyData(spheres->GetPointData(), i,
                                     points->InsertNextPoint(spheres->GetPoint(i)));
  left->SetPoints(points);
  return left;
}

void add_spheres(vtkRenderer* renderer, vtkPolyData* spheres, vtkColorTransferFunction* map)
{
  const vtkSmartPointer<vtkActor> actor = actor_of(spheres, map);
  actor->GetProperty()->SetColor(0.82, 0.80, 0.77);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(20.0);
  renderer->AddActor(actor);
}

void add_flat_spheres(vtkRenderer* renderer, vtkPolyData* spheres)
{
  const vtkSmartPointer<vtkActor> actor = actor_of(spheres, nullptr);
  actor->GetProperty()->SetColor(0.93, 0.93, 0.93);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  renderer->AddActor(actor);
}

}  // namespace encased_column
