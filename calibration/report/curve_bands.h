// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "stages/calibration.h"

#include <utility>

namespace encased_column {

/// The curves of one case: deviatoric stress [Pa] over axial strain [-].
struct CurveBand {
  std::string name;                       ///< of the case
  std::vector<double> strain, low, high;  ///< where 95 % of runs are expected; empty with few runs
  std::vector<std::pair<std::vector<double>, std::vector<double>>>
      best;                                                  ///< runs at the best point
  std::vector<double> laboratory_strain, laboratory_stress;  ///< empty without
};

/// Of each case. The band: a regression of the stress at each strain, over 200 points of the
/// posterior, with the scatter between packings.
std::vector<CurveBand> curve_bands(const CalibrationConfig& config, const Findings& found);

}  // namespace encased_column
