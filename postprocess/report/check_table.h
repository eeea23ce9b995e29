#pragma once

#include "report/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// The checks of all tests for reading, one row each, and a last line that says how many failed.
std::string check_text(const std::vector<SetResult>& sets);

/// The same as CSV, without the last line.
std::string check_csv(const std::vector<SetResult>& sets);

}  // namespace encased_column
