#pragma once

#include "reading/targets.h"
#include "report/evaluation.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// Draws into `folder` what only encased tests have, a panel for each test: radial_strain (at three
/// heights, with the study's end values), platens (q of both, with the closed form), radial_profile
/// (along the height) and hoop_tension (mean and largest, with the limit of the strip test). Leaves
/// out what the runs did not write; nothing without encased tests. Needs a display.
void draw_sleeve_figures(const std::filesystem::path& folder, const std::vector<SetResult>& sets,
                         const Targets& targets);

}  // namespace encased_column
