// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/places.h"
#include "runner/run_options.h"
#include "runner/stop_signals.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// `encase report` in a process of its own, as pictures may take a display made for it; false when
/// it fails.
bool make_report(const Places& places, const RunOptions& options,
                 const std::filesystem::path& series, StopSignals& signals);

/// What became of each case, on the screen and in cases.txt; false where one has not run to its
/// end.
bool tell_outcomes(const std::vector<CasePlan>& plans, const std::filesystem::path& series);

/// Where the results lie.
void tell_results(const std::filesystem::path& series, const RunOptions& options);

}  // namespace encased_column
