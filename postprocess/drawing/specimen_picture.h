#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// Draws the grains of `grains` (VTK XML PolyData one point at least, with
/// the arrays radius [m] and displacement [m])
/// into `file`.png: shaded spheres, colored by how far they moved, `caption` above. Needs a
/// display. Throws InputError if an array is missing or the picture cannot be written.
void draw_specimen(const std::filesystem::path& file, const std::filesystem::path& grains,
                   const std::string& caption);

}  // namespace encased_column
