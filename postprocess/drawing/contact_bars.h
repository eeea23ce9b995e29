// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <vtkSmartPointer.h>

#include <filesystem>
#include <vector>

class vtkColorTransferFunction;
class vtkPolyData;
class vtkRenderer;

namespace encased_column {

/// A contact as a picture shows it.
struct ContactBar {
  Vec3 from, to;  ///< [m]
  double force;   ///< [N]
};

/// The contacts of `file`, lines of VTK's XML, that bear `least` [N]. Throws InputError if it has
/// no forces.
std::vector<ContactBar> contact_bars(const std::filesystem::path& file, double least);

/// The bars with their forces [N] as scalars, that of 1 N with the radius `radius` [m].
vtkSmartPointer<vtkPolyData> sticks_of(const std::vector<ContactBar>& bars, double radius);

/// Adds them in the colors of `map`.
void add_sticks(vtkRenderer* renderer, vtkPolyData* sticks, vtkColorTransferFunction* map);

}  // namespace encased_column
