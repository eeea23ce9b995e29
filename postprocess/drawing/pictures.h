// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/frame_files.h"
#include "tables/evaluation.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// Draws into `file`.png the deformed sleeve of `frame`, coloured by its hoop tension, and the
/// grains in it; a quarter of both, as seen from above, is cut out along the sleeve's axis. Needs a
/// display. Throws InputError if a file lacks an array or the picture cannot be written.
void draw_sleeve(const std::filesystem::path& file, const FrameWithGrains& frame,
                 const std::string& caption);

/// Draws the grains of `grains` (VTK XML PolyData one point at least, with
/// the arrays radius [m] and displacement [m])
/// into `file`.png: shaded spheres, colored by how far they moved, `caption` above. Needs a
/// display. Throws InputError if an array is missing or the picture cannot be written.
void draw_specimen(const std::filesystem::path& file, const std::filesystem::path& grains,
                   const std::string& caption);

/// Draws into `file`.png the contacts of `frame` that bear 5 N and more, as the study does, as bars
/// as thick as their force and coloured by it, before the specimen's outline. False, and no
/// picture, where there is none. Needs a display. Throws InputError if a file lacks an array or the
/// picture cannot be written.
bool draw_force_chains(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption);

/// A state of a run and what is told of its time.
struct NamedFrame {
  FrameWithGrains frame;
  std::string name;  ///< "axial strain 0.0 %"
};

/// The same of `before` and `after` loading side by side, with bars and colors of one scale and
/// their largest forces (Figure 13a). False where neither has such a contact.
bool draw_force_chains(const std::filesystem::path& file, const NamedFrame& before,
                       const NamedFrame& after, const std::string& caption);

/// The same for the contacts that bear the study's 20, 40 and 60 N (Figure 13b), side by side with
/// bars and colors of one scale. Levels below `recorded` [N], from which on the file has all
/// contacts, are left out, by default those below its weakest; false where none is left.
bool draw_force_levels(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption, std::optional<double> recorded);

/// Draws into `file`.png the grains of `grains` (VTK's XML) that lie behind a plane through the
/// specimen's axis, coloured by the deviatoric strain about each, those of unknown strain grey.
/// False, and no picture, where the file knows no strain. Needs a display. Throws InputError if the
/// picture cannot be written.
bool draw_shear_band(const std::filesystem::path& file, const std::filesystem::path& grains,
                     const std::string& caption);

/// What draws the 3-D pictures of each run into `folder`, a task each, as far as the run wrote what
/// they show; says what is left out and why. Needs a display. Refers to `sets`.
std::vector<std::function<void()>> run_picture_tasks(const std::filesystem::path& folder,
                                                     const std::vector<SetResult>& sets);

}  // namespace encased_column
