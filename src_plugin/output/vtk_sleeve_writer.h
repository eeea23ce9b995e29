#pragma once

#include "shell/shell_model.h"

#include <string>

namespace encased_column {

/// Writes a sleeve as triangles of a VTK XML file (.vtp), reals in single precision; displacements
/// count from the positions `before`, radial ones about `axis`. False when the file cannot be
/// written.
///
/// Per node: displacement, radial_displacement [m], rotation [rad], velocity [m/s]. Per facet: hoop
/// and axial strain [-], hoop_tension, axial_force, shear_force [N/m], hoop_moment, axial_moment [N
/// m/m], energy [J], plastic_hoop_strain, plastic_axial_strain, damage (of the worse direction)
/// [-]. Tension and stretch are positive.
bool write_sleeve(const std::string& path, const ShellModel& model, const std::vector<Vec3>& before,
                  const Vec3& axis);

}  // namespace encased_column
