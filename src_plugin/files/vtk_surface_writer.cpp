#include "files/vtk_surface_writer.h"

#include "files/vtk_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace encased_column {

namespace {

void add_fields(vtkDataSetAttributes* to, const std::vector<SurfaceField>& fields)
{
  for (const SurfaceField& field : fields) {
    vtkNew<vtkFloatArray> array;
    array->SetName(field.name.c_str());
    array->SetNumberOfComponents(field.components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(field.values.size()) / field.components);
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
      array->SetTuple(n, field.values.data() + n * field.components);
    to->AddArray(array);
  }
}

}  // namespace

bool write_surface(const std::string& path, const std::vector<Vec3>& nodes,
                   const std::vector<Facet>& facets, const std::vector<SurfaceField>& at_nodes,
                   const std::vector<SurfaceField>& at_facets)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(nodes.size()));
  vtkIdType place = 0;
  for (const Vec3& node : nodes) points->SetPoint(place++, node.data());
  vtkNew<vtkCellArray> triangles;
  for (const Facet& facet : facets) {
    const vtkIdType corners[3] = {facet[0], facet[1], facet[2]};
    triangles->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  add_fields(data->GetPointData(), at_nodes);
  add_fields(data->GetCellData(), at_facets);
  return write_poly_data(path, data);
}

}  // namespace encased_column
