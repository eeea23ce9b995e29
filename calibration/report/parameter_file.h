// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "stages/calibration.h"

namespace encased_column {

/// A file of parameters that decks include by name, `variable NAME index VALUE # [unit] ...`.
struct ParameterFile {
  std::string name;  ///< "parameters_gravel.lmp"
  std::string text;
};

/// The values at the best point with their intervals: parameters_NAME.lmp for what the decks read
/// from there, sleeve_NAME.lmp for the sleeve. `set` is the set of parameters the runs began with,
/// which the files include for all else; `common` the folder of its files.
std::vector<ParameterFile> parameter_files(const CalibrationConfig& config, const Findings& found,
                                           const std::filesystem::path& common);

}  // namespace encased_column
