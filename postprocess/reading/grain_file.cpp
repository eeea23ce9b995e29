#include "reading/grain_file.h"

#include "reading/frame_files.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <string>

namespace encased_column {

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

std::optional<FrameWithGrains> last_frame_with_grains(const fs::path& folder,
                                                      const std::string& series)
{
  const fs::path others = folder / series / (series + ".pvd");
  const fs::path grains = folder / "grains" / "grains.pvd";
  if (!fs::exists(others) || !fs::exists(grains)) return std::nullopt;
  const auto other_at = frame_files(others), grains_at = frame_files(grains);
  for (auto frame = other_at.rbegin(); frame != other_at.rend(); ++frame) {
    const auto same = grains_at.find(frame->first);
    if (same != grains_at.end() && fs::exists(frame->second) && fs::exists(same->second))
      return FrameWithGrains{frame->second, same->second};
  }
  return std::nullopt;
}

}  // namespace encased_column
