// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <vector>

namespace encased_column::testing {

/// Files of the tree below `source`, but for what builds, runs and hidden folders hold.
std::vector<std::filesystem::path> files_of_tree(const std::filesystem::path& source);

}  // namespace encased_column::testing
