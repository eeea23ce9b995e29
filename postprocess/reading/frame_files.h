// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// The files a ParaView collection `collection` (.pvd) lists, by their time; of one time the last.
/// Throws InputError if it cannot be read or lists none.
std::map<double, std::filesystem::path> frame_files(const std::filesystem::path& collection);

/// Throws the InputError of a collection in which `found` was found, not files of points.
[[noreturn]] void refuse_collection(const std::filesystem::path& collection,
                                    const std::string& found);

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
  double time;  ///< as the collections have it
};

/// The last time of which `folder` holds a file of both `series`/`series`.pvd and
/// grains/grains.pvd; nothing if there is none, as of the sleeve in plain runs. Throws InputError
/// if a collection cannot be read.
std::optional<FrameWithGrains> last_frame_with_grains(const std::filesystem::path& folder,
                                                      const std::string& series);

/// The first such time.
std::optional<FrameWithGrains> first_frame_with_grains(const std::filesystem::path& folder,
                                                       const std::string& series);

/// How many of `centers` [m] lie behind the sleeve of `file` (.vtp) as seen from the z axis: the
/// straight way to them from the axis, at their own height, goes through a facet. A sleeve that is
/// folded back over itself would count grains before the fold; above and below it none is counted.
/// Throws InputError if `file` holds no facets.
long count_beyond_sleeve(const std::vector<std::array<double, 3>>& centers,
                         const std::filesystem::path& file);

}  // namespace encased_column
