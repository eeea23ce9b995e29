// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/run_checks.h"
#include "reading/case_run.h"
#include "reading/frame_files.h"

#include <optional>

namespace encased_column {

/// Whether a grain of `grains`, the last file of `run`, has left through a wall: found again from
/// the files, not from the watch the run keeps over itself. Platens and cylinder are where
/// case.json and the history's row of that step place them, the sleeve is that of its own file;
/// without one the platens are looked at alone. Not made, with the reason in its name, where a file
/// or a variable is missing.
Check outside_check(const CaseRun& run, const std::optional<GrainFile>& grains);

}  // namespace encased_column
