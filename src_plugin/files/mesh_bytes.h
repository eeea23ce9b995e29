// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace encased_column {

/// Whether the bytes of a mesh file are all there, and what they say of their own sizes is so.
/// VTK's readers take what they find of a file that ends too early, and numbers in it for sizes of
/// memory and loops. `kind` is ".stl", ".vtk" or ".vtp".
bool is_whole_mesh(const std::string& kind, const std::string& bytes);

}  // namespace encased_column
