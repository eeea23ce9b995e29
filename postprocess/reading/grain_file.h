#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// The last state of the grains a run left.
struct GrainFile {
  std::filesystem::path file;                  ///< of VTK's XML PolyData, one point per grain
  double time;                                 ///< as the collection has it
  long grains;                                 ///< their number
  std::vector<std::array<double, 3>> centers;  ///< [m]
};

/// Reads the collection `folder`/grains/grains.pvd; nothing if the run wrote none. Throws
/// InputError if the collection or the last file it names cannot be read.
std::optional<GrainFile> last_grain_file(const std::filesystem::path& folder);

/// What else a run wrote, as its sleeve or its contacts, and the grains at the same time.
struct FrameWithGrains {
  std::filesystem::path file, grains;
};

/// The last time of which `folder` holds a file of both `series`/`series`.pvd and
/// grains/grains.pvd; nothing if there is none, as of the sleeve in plain runs. Throws InputError
/// if a collection cannot be read.
std::optional<FrameWithGrains> last_frame_with_grains(const std::filesystem::path& folder,
                                                      const std::string& series);

}  // namespace encased_column
