#pragma once

#include "tables/evaluation.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// Draws the 3-D pictures of each run into `folder`, as far as the run wrote what they show, and
/// says what is left out and why. Needs a display.
void draw_run_pictures(const std::filesystem::path& folder, const std::vector<SetResult>& sets);

}  // namespace encased_column
