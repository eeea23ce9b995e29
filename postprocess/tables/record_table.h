#pragma once

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

}  // namespace encased_column
