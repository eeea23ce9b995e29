#include "files/vtk_grains_writer.h"

#include "core/vec3.h"
#include "files/vtk_file.h"

#include <vtkCellArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace encased_column {

namespace {

using Grains = std::vector<GrainRecord>;

void add_integers(vtkPolyData* data, const char* name, const Grains& grains,
                  int GrainRecord::*field)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(grains.size()));
  vtkIdType n = 0;
  for (const GrainRecord& grain : grains) array->SetValue(n++, grain.*field);
  data->GetPointData()->AddArray(array);
}

/// One vertex per point: ParaView draws cells, not points.
void add_points(vtkPolyData* data, const Grains& grains)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  points->SetNumberOfPoints(static_cast<vtkIdType>(grains.size()));
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n) {
    points->SetPoint(n, grains[static_cast<std::size_t>(n)].position.data());
    vertices->InsertNextCell(1, &n);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
}

}  // namespace

bool write_grains(const std::string& path, const Grains& grains, const GrainFileOptions& options)
{
  vtkNew<vtkPolyData> data;
  add_points(data, grains);
  const int count = static_cast<int>(grains.size());
  const auto add_vectors = [&](const char* name, std::array<double, 3> GrainRecord::*field) {
    add_array<3>(data->GetPointData(), name, count,
                 [&](int i) { return as_vec3((grains[i].*field).data()); });
  };
  add_integers(data, "id", grains, &GrainRecord::id);
  add_integers(data, "type", grains, &GrainRecord::type);
  add_array<1>(data->GetPointData(), "radius", count, [&](int i) { return grains[i].radius; });
  add_vectors("displacement", &GrainRecord::displacement);
  if (options.rotation) add_vectors("rotation", &GrainRecord::rotation);
  add_vectors("velocity", &GrainRecord::velocity);
  if (options.strain)
    add_array<1>(data->GetPointData(), "deviatoric_strain [-]", count,
                 [&](int i) { return grains[i].deviatoric_strain; });
  add_integers(data, "coordination_number", grains, &GrainRecord::coordination_number);
  return write_poly_data(path, data, options.compress);
}

}  // namespace encased_column
