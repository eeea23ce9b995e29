#include "reading/frame_files.h"

#include "core/input_error.h"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

namespace encased_column {

namespace fs = std::filesystem;

void refuse_collection(const fs::path& collection, const std::string& found)
{
  const fs::path folder = collection.parent_path();
  throw InputError("'" + collection.string() + "' must list .vtp files with points, found " +
                   found + ", run the case again or remove its folder " +
                   folder.filename().string());
}

std::map<double, fs::path> frame_files(const fs::path& collection)
{
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile(collection.c_str()));
  vtkXMLDataElement* list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!list) refuse_collection(collection, "no element Collection");
  std::map<double, fs::path> files;
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* element = list->GetNestedElement(i);
    double time = 0.0;
    element->GetScalarAttribute("timestep", time);
    if (const char* file = element->GetAttribute("file"))
      files[time] = collection.parent_path() / file;
  }
  if (files.empty()) refuse_collection(collection, "no file in it");
  return files;
}

}  // namespace encased_column
