#include "drawing/grain_spheres.h"

#include "core/input_error.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>

namespace encased_column {

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkDataArray* array_of(vtkDataSetAttributes* arrays, const std::string& name,
                       const std::string& unit, int components, const std::filesystem::path& file)
{
  for (const std::string& full : {name, name + " [" + unit + "]"}) {
    vtkDataArray* array = arrays->GetArray(full.c_str());
    if (array && array->GetNumberOfComponents() == components) return array;
  }
  throw InputError("'" + file.string() + "' must have an array '" + name + "' of " +
                   std::to_string(components) +
                   " component(s), found none, write the file with the same version");
}

vtkSmartPointer<vtkPolyData> grain_spheres(const std::filesystem::path& file)
{
  const vtkSmartPointer<vtkPolyData> grains = read_poly_data(file);
  vtkDataArray* radius = array_of(grains->GetPointData(), "radius", "m", 1, file);
  vtkDataArray* displacement = array_of(grains->GetPointData(), "displacement", "m", 3, file);

  vtkNew<vtkFloatArray> sphere_radius;  // the mapper takes no double
  vtkNew<vtkDoubleArray> moved;
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

void add_spheres(vtkRenderer* renderer, vtkPolyData* spheres, vtkColorTransferFunction* map)
{
  // Each sphere is one square that the shader rounds: no facets, and fast without a graphics card.
  // It draws vertices, not bare points.
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < spheres->GetNumberOfPoints(); ++i) vertices->InsertNextCell(1, &i);
  spheres->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(spheres);
  mapper->SetScaleArray("sphere_radius");
  if (map) {
    mapper->SetLookupTable(map);
    mapper->SetColorModeToMapScalars();
    mapper->UseLookupTableScalarRangeOn();
  } else
    mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.82, 0.80, 0.77);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(20.0);
  renderer->AddActor(actor);
}

}  // namespace encased_column
