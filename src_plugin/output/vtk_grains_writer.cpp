#include "output/vtk_grains_writer.h"

#include "output/whole_file.h"

#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

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

void add_scalars(vtkPolyData* data, const char* name, const Grains& grains,
                 double GrainRecord::*field)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(grains.size()));
  vtkIdType n = 0;
  for (const GrainRecord& grain : grains) array->SetValue(n++, static_cast<float>(grain.*field));
  data->GetPointData()->AddArray(array);
}

void add_vectors(vtkPolyData* data, const char* name, const Grains& grains,
                 std::array<double, 3> GrainRecord::*field)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(grains.size()));
  vtkIdType n = 0;
  for (const GrainRecord& grain : grains) array->SetTuple(n++, (grain.*field).data());
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
  add_integers(data, "id", grains, &GrainRecord::id);
  add_integers(data, "type", grains, &GrainRecord::type);
  add_scalars(data, "radius", grains, &GrainRecord::radius);
  add_vectors(data, "displacement", grains, &GrainRecord::displacement);
  if (options.rotation) add_vectors(data, "rotation", grains, &GrainRecord::rotation);
  add_vectors(data, "velocity", grains, &GrainRecord::velocity);
  add_integers(data, "coordination_number", grains, &GrainRecord::coordination_number);

  vtkObject::GlobalWarningDisplayOff();  // the caller says what went wrong, once
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(unfinished(path).c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (options.compress)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToNone();
  const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
  return written && finish_file(path);
}

}  // namespace encased_column
