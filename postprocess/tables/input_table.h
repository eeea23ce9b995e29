#pragma once

#include "reading/case_run.h"
#include "tables/text_layout.h"

#include <string>

namespace encased_column {

/// The variables of `run` with values in an engineer's units, below a row of headings.
Rows input_rows(const CaseRun& run);

/// The grains asked for and drawn, class by class, below a row of headings; only these without
/// gradation.csv.
Rows gradation_rows(const CaseRun& run);

/// The arguments of `./input_scripts/run` that repeat the run whose host was started by `command`.
std::string repeat_arguments(const CaseRun& run, const std::string& command);

}  // namespace encased_column
