#pragma once

#include "report/evaluation.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// Draws into `folder` how well the runs went: checks (unbalanced ratio, inertial number, platen
/// difference of plain tests, over axial strain) and energy_<id> (where the work of each test
/// went). Needs a display.
void draw_run_figures(const std::filesystem::path& folder, const std::vector<SetResult>& sets);

}  // namespace encased_column
