#pragma once

#include <filesystem>
#include <optional>

namespace encased_column {

/// The last state of the grains a run left.
struct GrainFile {
  std::filesystem::path file;  ///< of VTK's XML PolyData, one point per grain
  long grains;                 ///< their number
};

/// Reads the collection `folder`/grains/grains.pvd; nothing if the run wrote none. Throws
/// InputError if the collection or the last file it names cannot be read.
std::optional<GrainFile> last_grain_file(const std::filesystem::path& folder);

/// The sleeve and the grains in it at the same time.
struct SleeveFiles {
  std::filesystem::path sleeve, grains;
};

/// The last time of which `folder` holds both sleeve/sleeve.pvd and grains/grains.pvd; nothing if
/// there is none, as in plain runs. Throws InputError if a collection cannot be read.
std::optional<SleeveFiles> last_sleeve_files(const std::filesystem::path& folder);

}  // namespace encased_column
