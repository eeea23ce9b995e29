// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>
#include <vector>

namespace encased_column {

/// The checks of all tests, one row each, below a row of headings; the set of parameters stands
/// beside the test where the runs say it.
Rows check_rows(const std::vector<SetResult>& sets);

/// How many of the required checks failed, and how many could not be made.
struct CheckCount {
  int failed = 0, not_made = 0, required = 0;
  int passed() const { return required - failed - not_made; }
  std::string sentence() const;
};
CheckCount count_checks(const std::vector<SetResult>& sets);

/// The checks of all tests for reading, one row each, and a last line that says how many failed.
std::string check_text(const std::vector<SetResult>& sets);

/// The same as CSV, without the last line.
std::string check_csv(const std::vector<SetResult>& sets);

}  // namespace encased_column
