// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "files/vtk_files.h"
#include "shell/shell_model.h"

#include <vector>

namespace encased_column {

/// What the VTK file of a sleeve holds at its nodes: displacement, radial_displacement [m],
/// rotation [rad], velocity [m/s]. Displacements count from the positions `before`, radial ones
/// about `axis`.
std::vector<SurfaceField> sleeve_node_fields(const ShellModel& model,
                                             const std::vector<Vec3>& before, const Vec3& axis);

/// What it holds in each facet: hoop and axial strain [-], hoop_tension, axial_force, shear_force
/// [N/m], hoop_moment, axial_moment [N m/m], energy [J], plastic_hoop_strain, plastic_axial_strain,
/// damage (of the worse direction) [-]. Tension and stretch are positive.
std::vector<SurfaceField> sleeve_facet_fields(const ShellModel& model);

}  // namespace encased_column
