#pragma once

#include "shell/surface_mesh.h"

#include <string>

namespace encased_column {

/// The triangles of a .stl, .vtk or .vtp file as a mesh that shares its nodes: corners closer than
/// a millionth of the file's extent are one. Throws InputError for what cannot be read or holds no
/// triangle.
SurfaceMesh read_mesh_file(const std::string& path);

}  // namespace encased_column
