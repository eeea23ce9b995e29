#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Writes a table as points of a VTK XML file: each row a point at its "x [m]", "y [m]", "z [m]",
/// every other column an array of that name. False when the file cannot be written.
bool write_spheres(const std::string& path, const std::vector<std::string>& columns,
                   const std::vector<std::vector<double>>& rows);

}  // namespace encased_column
