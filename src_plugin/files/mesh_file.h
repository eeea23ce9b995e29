// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <array>
#include <string>
#include <vector>

namespace encased_column {

/// The corners [m] of the triangles of a .stl, .vtk or .vtp file. Throws InputError for what cannot
/// be read or holds no triangle.
std::vector<std::array<Vec3, 3>> read_mesh_file(const std::string& path);

}  // namespace encased_column
