// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "stages/calibration.h"

namespace encased_column {

/// The page of a calibration, which needs no other file. `files` are the names of the parameter
/// files.
std::string calibration_page(const CalibrationConfig& config, const Findings& found,
                             const std::string& files);

/// The table parameters / best / interval / correlation as text, for the screen and for pages.
std::string parameter_text(const CalibrationConfig& config, const Findings& found);

}  // namespace encased_column
