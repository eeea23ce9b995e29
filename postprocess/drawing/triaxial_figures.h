#pragma once

#include "reading/targets.h"
#include "report/evaluation.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// Draws into `folder`: deviatoric_stress and volumetric_strain over axial strain, one curve for
/// each test, and p_q, the peaks with the fitted and the published failure lines of each set.
/// Where a folder holds plain and encased tests, the plain ones are dashed. Needs a display.
void draw_triaxial_figures(const std::filesystem::path& folder, const std::vector<SetResult>& sets,
                           const Targets& targets);

}  // namespace encased_column
