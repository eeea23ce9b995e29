// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>
#include <vector>

namespace encased_column {

/// All rows of `targets` beside what the runs of each set of parameters gave, below a row of
/// headings: the value found, the mean where several runs meet a row, and its ratio to the
/// laboratory's, or to the model's where the laboratory has none. "not run" where no run is of a
/// row's test, "not told" where it did not go so far or did not write it.
Rows target_rows(const std::vector<SetResult>& sets, const Targets& targets);

/// The same for reading.
std::string target_text(const std::vector<SetResult>& sets, const Targets& targets);

/// The same as CSV, with the source of each row and the runs that each value is of.
std::string target_csv(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
