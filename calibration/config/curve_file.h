// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/sampled_curve.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// A curve of the laboratory: deviatoric stress [Pa] over axial strain [-]. Reads a CSV file with
/// the columns `axial_strain [-]` (or [%]) and `deviatoric_stress [Pa]` (or [kPa], [MPa]), rising
/// in strain. Throws InputError, which begins with `place`.
SampledCurve read_curve_file(const std::filesystem::path& file, const std::string& place);

}  // namespace encased_column
