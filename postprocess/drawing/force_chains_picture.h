#pragma once

#include "reading/grain_file.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// Draws into `file`.png the contacts of `frame` that bear 5 N and more, as the study does, as bars
/// as thick as their force and coloured by it, before the specimen's outline. False, and no
/// picture, where there is none. Needs a display. Throws InputError if a file lacks an array or the
/// picture cannot be written.
bool draw_force_chains(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption);

}  // namespace encased_column
