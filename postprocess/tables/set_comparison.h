// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>
#include <vector>

namespace encased_column {

/// Plain or encased tests made with several sets of parameters.
struct SetComparison {
  std::string set;      ///< as in targets.csv
  std::string caption;  ///< "Plain triaxial tests by their parameters, ..."
  Rows rows;            ///< below headings: what the study gives values for, a column a set
};

/// One for each kind of tests that `sets` have with several sets of parameters.
std::vector<SetComparison> set_comparisons(const std::vector<SetResult>& sets,
                                           const Targets& targets);

/// The same for reading; empty if there is none.
std::string comparison_text(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
