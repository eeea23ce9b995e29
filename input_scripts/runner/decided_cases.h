// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"
#include "runner/run_cases.h"
#include "runner/run_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// The cases of a command, and what was decided about them.
struct Decided {
  std::vector<Todo> todo;           ///< to run, the longest first
  std::vector<std::string> failed;  ///< before, and left so
};

/// Makes it with those above. Throws InputError where nothing can be written there.
void make_folder(const std::filesystem::path& folder);

/// Decides what becomes of each case and says so. Throws InputError before anything was touched.
Decided decide_all(const std::vector<CasePlan>& plans, const std::filesystem::path& series,
                   const Places& places, const RunOptions& options);

}  // namespace encased_column
