// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "files/column.h"
#include "shell/sleeve_profile.h"
#include "shell/sleeve_state.h"

#include <vector>

namespace encased_column {

/// One row of the curves of a sleeve.
struct SleeveCurves {
  double step, axial_strain;
  double pressure;  ///< [Pa]
  SleeveSummary summary;
  double axial_force_top, axial_force_bottom;  ///< [N]
  double friction_force;                       ///< [N]
  double enclosed_volume;                      ///< [m^3]
  double energy;                               ///< [J]
  double dissipated;                           ///< [J]
};

/// One row of its profile over the height.
struct SleeveLevel {
  double step, axial_strain;
  ProfilePoint point;
};

/// Their columns, in their order.
const std::vector<Column<SleeveCurves>>& sleeve_columns();
const std::vector<Column<SleeveLevel>>& profile_columns();

}  // namespace encased_column
