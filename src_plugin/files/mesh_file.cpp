#include "files/mesh_file.h"

#include "core/input_error.h"
#include "core/surface_mesh.h"

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

#include <cstdint>
#include <cstring>
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

template <typename Reader>
vtkSmartPointer<vtkPolyData> triangles_of(const std::string& path)
{
  const Listening listening;
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  const auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (listening.heard_any() || reader->GetErrorCode() != 0)
    refuse(path, "be a whole file of its format", "one that is cut off or damaged");
  return triangles->GetOutput();
}

std::size_t count_of(const std::string& words, const std::string& text)
{
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

// The readers take what they find of a file that ends too early: STL in bytes tells its size, the
// texts their end.
bool is_whole_stl(const std::string& text)
{
  constexpr std::size_t head = 84, facet = 50;
  if (text.size() >= head) {
    std::uint32_t facets;
    std::memcpy(&facets, text.data() + head - 4, sizeof(facets));
    if (text.size() == head + facet * facets) return true;
  }
  const std::size_t facets = count_of("facet normal", text);
  return text.compare(0, 5, "solid") == 0 && text.find('\0') == std::string::npos &&
         count_of("endfacet", text) == facets && count_of("vertex", text) == 3 * facets &&
         count_of("endsolid", text) > 0 &&
         text.find("facet", text.rfind("endsolid")) == std::string::npos;
}

bool is_whole(const std::string& kind, const std::string& text)
{
  if (kind == ".stl") return is_whole_stl(text);
  if (kind == ".vtp") return text.find("</VTKFile>") != std::string::npos;
  return !text.empty() && text.back() == '\n';  // else its last number may lack digits
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
  if (!is_whole(kind, {std::istreambuf_iterator<char>(file), {}}))
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
      if (ids->GetId(i) < 0 || ids->GetId(i) >= data->GetNumberOfPoints())
        refuse(path, "name points that it holds", "point " + std::to_string(ids->GetId(i)));
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
