// SPDX-License-Identifier: GPL-2.0-only
#include "files/mesh_file.h"

#include "core/input_error.h"
#include "core/surface_mesh.h"
#include "files/mesh_bytes.h"

#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace encased_column {

namespace {

/// Catches the messages of VTK's readers, which would go to the screen: a file they take a part of
/// is refused.
class Complaints : public vtkOutputWindow {
 public:
  static Complaints* New();
  vtkTypeMacro(Complaints, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { any = true; }
  void DisplayWarningText(const char*) override { any = true; }

  bool any = false;
};
vtkStandardNewMacro(Complaints)

    /// Puts back, at its end, what VTK wrote to before.
    class Listening {
 public:
  Listening()
      : before_(vtkOutputWindow::GetInstance()),
        displays_(vtkObject::GetGlobalWarningDisplay())
  {
    vtkOutputWindow::SetInstance(complaints_);
    vtkObject::GlobalWarningDisplayOn();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Listening()
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);  // its default
    vtkObject::SetGlobalWarningDisplay(displays_);
    vtkOutputWindow::SetInstance(before_);
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  bool heard_any() const { return complaints_->any; }

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
  int displays_;
  vtkSmartPointer<Complaints> complaints_ = vtkSmartPointer<Complaints>::New();
};

[[noreturn]] void refuse(const std::string& path, const std::string& rule, const std::string& found)
{
  throw InputError("'file' must " + rule + ", found " + found + " in '" + path +
                   "', export the surface of the sleeve as triangles again");
}

/// VTK's filters take for granted that a cell begins where the one before ends, and that it names
/// points that are there.
void require_sound_cells(const std::string& path, vtkCellArray* cells, vtkIdType points)
{
  vtkDataArray* const begin = cells->GetOffsetsArray();
  vtkDataArray* const point = cells->GetConnectivityArray();
  const auto at = [](vtkDataArray* numbers, vtkIdType n) { return numbers->GetComponent(n, 0); };
  const vtkIdType bounds = begin->GetNumberOfValues(), corners = point->GetNumberOfValues();
  bool is_in_order = bounds == 0 || at(begin, 0) == 0.0;
  for (vtkIdType n = 1; n < bounds; ++n) is_in_order &= at(begin, n) >= at(begin, n - 1);
  if (!is_in_order || (bounds > 0 ? at(begin, bounds - 1) : 0.0) != static_cast<double>(corners))
    refuse(path, "be a whole file of its format", "one that is damaged");
  for (vtkIdType n = 0; n < corners; ++n)
    if (!(at(point, n) >= 0.0 && at(point, n) < static_cast<double>(points)))
      refuse(path, "name points that it holds", "point " + in_words(at(point, n)));
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> triangles_of(const std::string& path)
{
  const Listening listening;
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  if (listening.heard_any() || reader->GetErrorCode() != 0)
    refuse(path, "be a whole file of its format", "one that is cut off or damaged");
  vtkPolyData* const read = reader->GetOutput();
  for (vtkCellArray* cells : {read->GetPolys(), read->GetStrips()})
    require_sound_cells(path, cells, read->GetNumberOfPoints());
  const auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (listening.heard_any()) refuse(path, "hold triangles", "cells that cannot be cut into them");
  return triangles->GetOutput();
}

}  // namespace

std::vector<std::array<Vec3, 3>> read_mesh_file(const std::string& path)
{
  const std::string kind = std::filesystem::path(path).extension();
  if (kind != ".stl" && kind != ".vtk" && kind != ".vtp")
    throw InputError("'file' must end in .stl, .vtk or .vtp, found '" + path +
                     "', write the mesh in one of these formats");
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError("'file' must be a file that can be read, found '" + path +
                     "', write the path as seen from where the run starts");
  if (!is_whole_mesh(kind, {std::istreambuf_iterator<char>(file), {}}))
    refuse(path, "be a whole file of its format", "one that is cut off or damaged");
  vtkSmartPointer<vtkPolyData> data;
  try {
    data = kind == ".stl"   ? triangles_of<vtkSTLReader>(path)
           : kind == ".vtk" ? triangles_of<vtkPolyDataReader>(path)
                            : triangles_of<vtkXMLPolyDataReader>(path);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {  // sizes that no memory holds
    refuse(path, "be a whole file of its format", "one that is damaged");
  }
  if (data->GetNumberOfPolys() == 0) refuse(path, "hold triangles", "none");
  if (data->GetNumberOfPolys() > most_facets)
    refuse(path, "hold " + std::to_string(most_facets) + " triangles at most",
           std::to_string(data->GetNumberOfPolys()));
  std::vector<std::array<Vec3, 3>> triangle;
  for (vtkIdType c = 0; c < data->GetNumberOfPolys(); ++c) {
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    data->GetCellPoints(c, ids);
    std::array<Vec3, 3> facet;
    for (int i = 0; i < 3; ++i) {
      data->GetPoint(ids->GetId(i), facet[i].data());
      if (!facet[i].allFinite()) refuse(path, "hold finite coordinates", "one that is no number");
    }
    triangle.push_back(facet);
  }
  double bounds[6];
  data->GetBounds(bounds);
  double extent = 0.0;
  for (int a = 0; a < 3; ++a) extent = std::max(extent, bounds[2 * a + 1] - bounds[2 * a]);
  if (!(extent > 0.0)) refuse(path, "have an extent", "all points at one place");
  return triangle;
}

}  // namespace encased_column
