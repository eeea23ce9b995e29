#include "reading/grain_file.h"

#include "core/input_error.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <string>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& collection, const std::string& found)
{
  throw InputError("'" + collection.string() + "' must list .vtp files with grains, found " +
                   found + ", run the case again or remove its folder grains");
}

fs::path last_file_of(const fs::path& collection)
{
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile(collection.c_str()));
  vtkXMLDataElement* list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!list) refuse(collection, "no element Collection");
  const char* last = nullptr;
  double last_time = 0.0;
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* element = list->GetNestedElement(i);
    const char* file = element->GetAttribute("file");
    double time = 0.0;
    element->GetScalarAttribute("timestep", time);
    if (!file || (last && time < last_time)) continue;
    last = file;
    last_time = time;
  }
  if (!last) refuse(collection, "no file in it");
  return collection.parent_path() / last;
}

}  // namespace

std::optional<GrainFile> last_grain_file(const fs::path& folder)
{
  const fs::path collection = folder / "grains" / "grains.pvd";
  if (!fs::exists(collection)) return std::nullopt;
  const fs::path file = last_file_of(collection);
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!fs::exists(file) || !reader->CanReadFile(file.c_str()))
    refuse(collection, "'" + file.string() + "', which cannot be read");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
    refuse(collection, "'" + file.string() + "', which holds no grain or was cut off");
  return GrainFile{file, static_cast<long>(reader->GetOutput()->GetNumberOfPoints())};
}

}  // namespace encased_column
