#pragma once

#include "reading/grain_file.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// Draws into `file`.png the deformed sleeve of `frame`, coloured by its hoop tension, and the
/// grains in it; a quarter of both, as seen from above, is cut out along the sleeve's axis. Needs a
/// display. Throws InputError if a file lacks an array or the picture cannot be written.
void draw_sleeve(const std::filesystem::path& file, const FrameWithGrains& frame,
                 const std::string& caption);

}  // namespace encased_column
