#include "files/mesh_file.h"

#include "core/input_error.h"

#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>

namespace encased_column {

namespace {

template <typename Reader>
vtkSmartPointer<vtkPolyData> triangles_of(const std::string& path)
{
  vtkObject::GlobalWarningDisplayOff();  // the caller says what is wrong, in one sentence
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  const auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return triangles->GetOutput();
}

}  // namespace

std::vector<std::array<Vec3, 3>> read_mesh_file(const std::string& path)
{
  const std::string kind = std::filesystem::path(path).extension();
  if (kind != ".stl" && kind != ".vtk" && kind != ".vtp")
    throw InputError("'file' must end in .stl, .vtk or .vtp, found '" + path +
                     "', write the mesh in one of these formats");
  if (!std::ifstream(path))
    throw InputError("'file' must be a file that can be read, found '" + path +
                     "', write the path as seen from where the run starts");
  const vtkSmartPointer<vtkPolyData> data = kind == ".stl" ? triangles_of<vtkSTLReader>(path)
                                            : kind == ".vtk"
                                                ? triangles_of<vtkPolyDataReader>(path)
                                                : triangles_of<vtkXMLPolyDataReader>(path);
  std::vector<std::array<Vec3, 3>> triangle;
  for (vtkIdType c = 0; c < data->GetNumberOfPolys(); ++c) {
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    data->GetCellPoints(c, ids);
    std::array<Vec3, 3> facet;
    for (int i = 0; i < 3; ++i) data->GetPoint(ids->GetId(i), facet[i].data());
    triangle.push_back(facet);
  }
  if (triangle.empty())
    throw InputError("'file' must hold triangles, found none in '" + path +
                     "', export the surface of the sleeve as triangles");
  return triangle;
}

}  // namespace encased_column
