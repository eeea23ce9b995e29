// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/places.h"
#include "runner/run_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// Submits a job array for the cases `missing` and behind it a job for the report on all `plans`;
/// says what was submitted. Returns the exit code. Throws InputError where Slurm is missing or
/// refuses.
int submit_to_slurm(const Places& places, const RunOptions& options,
                    const std::filesystem::path& series, const std::vector<std::string>& missing,
                    const std::vector<CasePlan>& plans);

}  // namespace encased_column
