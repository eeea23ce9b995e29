// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// What became of one case of a series.
struct CaseOutcome {
  std::string id;
  std::string outcome;  ///< passed, checks missed, failed, stopped or not run
  std::string why;      ///< empty where there is nothing to say
  bool has_run() const { return outcome == "passed" || outcome == "checks missed"; }
};

/// Each case with its outcome and the reason, and a last line that counts them. It holds no times:
/// a series that was interrupted has the same table as one that was not.
std::string case_table(const std::vector<CaseOutcome>& outcomes);

/// The outcome of the case in `folder`, whose missed checks stand in the series' checks.csv.
CaseOutcome outcome_of(const CaseFolder& folder, const std::filesystem::path& checks_file);

}  // namespace encased_column
