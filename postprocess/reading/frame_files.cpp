// SPDX-License-Identifier: GPL-2.0-only
#include "reading/frame_files.h"

#include "core/input_error.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <string>

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

namespace fs = std::filesystem;

std::optional<GrainFile> last_grain_file(const fs::path& folder)
{
  const fs::path collection = folder / "grains" / "grains.pvd";
  if (!fs::exists(collection)) return std::nullopt;
  const auto [time, file] = *frame_files(collection).rbegin();
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!fs::exists(file) || !reader->CanReadFile(file.c_str()))
    refuse_collection(collection, "'" + file.string() + "', which cannot be read");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
    refuse_collection(collection, "'" + file.string() + "', which holds no grain or was cut off");
  GrainFile last{file, time, static_cast<long>(reader->GetOutput()->GetNumberOfPoints()), {}};
  last.centers.resize(static_cast<std::size_t>(last.grains));
  for (long i = 0; i < last.grains; ++i)
    reader->GetOutput()->GetPoint(i, last.centers[static_cast<std::size_t>(i)].data());
  return last;
}

namespace {

/// All times of which `folder` holds a file of both, in order.
std::vector<FrameWithGrains> frames_with_grains(const fs::path& folder, const std::string& series)
{
  std::vector<FrameWithGrains> frames;
  const fs::path others = folder / series / (series + ".pvd");
  const fs::path grains = folder / "grains" / "grains.pvd";
  if (!fs::exists(others) || !fs::exists(grains)) return frames;
  const auto grains_at = frame_files(grains);
  for (const auto& [time, file] : frame_files(others)) {
    const auto same = grains_at.find(time);
    if (same != grains_at.end() && fs::exists(file) && fs::exists(same->second))
      frames.push_back({file, same->second, time});
  }
  return frames;
}

}  // namespace

std::optional<FrameWithGrains> last_frame_with_grains(const fs::path& folder,
                                                      const std::string& series)
{
  const auto frames = frames_with_grains(folder, series);
  return frames.empty() ? std::nullopt : std::optional(frames.back());
}

std::optional<FrameWithGrains> first_frame_with_grains(const fs::path& folder,
                                                       const std::string& series)
{
  const auto frames = frames_with_grains(folder, series);
  return frames.empty() ? std::nullopt : std::optional(frames.front());
}

long count_beyond_sleeve(const std::vector<std::array<double, 3>>& centers,
                         const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPolys() == 0)
    throw InputError("'" + file.string() + "' must hold the facets of a sleeve, found none, " +
                     "run the case again or remove its folder sleeve");
  vtkNew<vtkStaticCellLocator> facets;
  facets->SetDataSet(reader->GetOutput());
  facets->BuildLocator();
  long beyond = 0;
  for (const std::array<double, 3>& center : centers) {
    const double axis[3] = {0.0, 0.0, center[2]};
    double way = 0.0, where[3], in_facet[3];
    int part = 0;
    beyond += facets->IntersectWithLine(axis, center.data(), 0.0, way, where, in_facet, part) != 0;
  }
  return beyond;
}

}  // namespace encased_column
