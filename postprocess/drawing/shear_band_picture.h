#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// Draws into `file`.png the grains of `grains` (VTK's XML) that lie behind a plane through the
/// specimen's axis, coloured by the deviatoric strain about each, those of unknown strain grey.
/// False, and no picture, where the file knows no strain. Needs a display. Throws InputError if the
/// picture cannot be written.
bool draw_shear_band(const std::filesystem::path& file, const std::filesystem::path& grains,
                     const std::string& caption);

}  // namespace encased_column
