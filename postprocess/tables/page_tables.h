// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/case_run.h"
#include "reading/run_record.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>

namespace encased_column {

/// When the run ended, how long it took, its steps, grains, porosities and rate, below a row of
/// headings.
Rows record_rows(const TestResult& test, const RunRecord& record);

/// Number, mean, largest force and strong shares of all contacts of `test` before and after shear;
/// only the headings if the run wrote none.
Rows contact_batchs(const TestResult& test);

/// The time a run took, with its unit; "-" if it is not known.
std::string time_of(const RunRecord& record);

/// Of this project, that made the run; "unknown" if the run does not say.
std::string version_of(const RunRecord& record);

/// The variables of `run` with values in an engineer's units, below a row of headings.
Rows input_rows(const CaseRun& run);

/// The grains asked for and drawn, class by class, below a row of headings; only these without
/// gradation.csv.
Rows gradation_rows(const CaseRun& run);

/// The arguments of `./input_scripts/run` that repeat the run whose host was started by `command`.
std::string repeat_arguments(const CaseRun& run, const std::string& command);

/// The measuring spheres of `test` before and after shear, a row each, with their mean and what the
/// walls say beside it; only the headings if the run has no spheres.
Rows column_rows(const TestResult& test);

}  // namespace encased_column
