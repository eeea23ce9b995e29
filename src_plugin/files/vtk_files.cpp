// SPDX-License-Identifier: GPL-2.0-only
#include "files/vtk_files.h"

#include "core/vec3.h"
#include "files/atomic_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

namespace encased_column {

namespace {

/// An array of `count` tuples in single precision, each what `value(n)` gives.
template <int components, typename Value>
void add_array(vtkDataSetAttributes* to, const char* name, int count, const Value& value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (int n = 0; n < count; ++n) {
    const Eigen::Matrix<double, components, 1> tuple(value(n));
    array->SetTuple(n, tuple.data());
  }
  to->AddArray(array);
}

template <typename Record>
void add_integers(vtkDataSetAttributes* to, const char* name, const std::vector<Record>& records,
                  int Record::*field)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(records.size()));
  vtkIdType n = 0;
  for (const Record& record : records) array->SetValue(n++, record.*field);
  to->AddArray(array);
}

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

/// One vertex per point: ParaView draws cells, not points.
template <typename Position>
void add_points(vtkPolyData* data, std::size_t count, const Position& position)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n) {
    points->SetPoint(n, position(static_cast<std::size_t>(n)).data());
    vertices->InsertNextCell(1, &n);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
}

void add_lines(vtkPolyData* data, const std::vector<ContactRecord>& contacts)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->SetNumberOfPoints(2 * static_cast<vtkIdType>(contacts.size()));
  vtkIdType ends[2] = {0, 1};
  for (const ContactRecord& contact : contacts) {
    points->SetPoint(ends[0], contact.from.data());
    points->SetPoint(ends[1], contact.to.data());
    lines->InsertNextCell(2, ends);
    for (vtkIdType& end : ends) end += 2;
  }
  data->SetPoints(points);
  data->SetLines(lines);
}

void add_triangles(vtkPolyData* data, const std::vector<Vec3>& nodes,
                   const std::vector<Facet>& facets)
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
  data->SetPoints(points);
  data->SetPolys(triangles);
}

/// Arrays in raw binary; false when the file cannot be written.
bool write_poly_data(const std::string& path, vtkPolyData* data, bool compress = true)
{
  vtkObject::GlobalWarningDisplayOff();  // the caller says what went wrong, once
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(unfinished(path).c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (compress)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToNone();
  const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
  return written && finish_file(path);
}

}  // namespace

bool write_grains(const std::string& path, const std::vector<GrainRecord>& grains,
                  const GrainFileOptions& options)
{
  vtkNew<vtkPolyData> data;
  add_points(data, grains.size(),
             [&](std::size_t n) { return as_vec3(grains[n].position.data()); });
  vtkPointData* const at_points = data->GetPointData();
  const int count = static_cast<int>(grains.size());
  const auto add_vectors = [&](const char* name, std::array<double, 3> GrainRecord::*field) {
    add_array<3>(at_points, name, count, [&](int i) { return as_vec3((grains[i].*field).data()); });
  };
  add_integers(at_points, "id", grains, &GrainRecord::id);
  add_integers(at_points, "type", grains, &GrainRecord::type);
  add_array<1>(at_points, "radius", count, [&](int i) { return grains[i].radius; });
  add_vectors("displacement", &GrainRecord::displacement);
  if (options.rotation) add_vectors("rotation", &GrainRecord::rotation);
  add_vectors("velocity", &GrainRecord::velocity);
  if (options.strain)
    add_array<1>(at_points, "deviatoric_strain [-]", count,
                 [&](int i) { return grains[i].deviatoric_strain; });
  add_integers(at_points, "coordination_number", grains, &GrainRecord::coordination_number);
  return write_poly_data(path, data, options.compress);
}

bool write_contacts(const std::string& path, const std::vector<ContactRecord>& contacts)
{
  vtkNew<vtkPolyData> data;
  add_lines(data, contacts);
  vtkCellData* const on_lines = data->GetCellData();
  const int count = static_cast<int>(contacts.size());
  add_array<1>(data->GetPointData(), "force [N]", 2 * count,
               [&](int point) { return contacts[point / 2].force; });
  add_array<1>(on_lines, "normal_force [N]", count,
               [&](int n) { return contacts[n].normal_force; });
  add_array<1>(on_lines, "shear_force [N]", count, [&](int n) { return contacts[n].shear_force; });
  add_integers(on_lines, "kind [-]", contacts, &ContactRecord::kind);
  add_integers(on_lines, "sliding [-]", contacts, &ContactRecord::sliding);
  return write_poly_data(path, data);
}

bool write_spheres(const std::string& path, const std::vector<std::string>& columns,
                   const std::vector<std::vector<double>>& rows)
{
  const std::array<std::string, 3> coordinates{"x [m]", "y [m]", "z [m]"};
  std::array<std::size_t, 3> place{};
  for (int a = 0; a < 3; ++a)
    place[a] = std::find(columns.begin(), columns.end(), coordinates[a]) - columns.begin();

  vtkNew<vtkPolyData> data;
  add_points(data, rows.size(), [&](std::size_t n) {
    return Vec3(rows[n][place[0]], rows[n][place[1]], rows[n][place[2]]);
  });
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (std::find(place.begin(), place.end(), c) == place.end())
      add_array<1>(data->GetPointData(), columns[c].c_str(), static_cast<int>(rows.size()),
                   [&](int n) { return rows[n][c]; });
  return write_poly_data(path, data);
}

bool write_surface(const std::string& path, const std::vector<Vec3>& nodes,
                   const std::vector<Facet>& facets, const std::vector<SurfaceField>& at_nodes,
                   const std::vector<SurfaceField>& at_facets)
{
  vtkNew<vtkPolyData> data;
  add_triangles(data, nodes, facets);
  add_fields(data->GetPointData(), at_nodes);
  add_fields(data->GetCellData(), at_facets);
  return write_poly_data(path, data);
}

}  // namespace encased_column
