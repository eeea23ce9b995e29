// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "search/posterior.h"

#include <string>
#include <vector>

namespace encased_column {

/// How much the data tell of a parameter.
enum class Knowledge { told, partly, not_told };

/// The standard deviation of a column of the posterior over that of the whole range: at most 0.35
/// is told, from 0.7 on not told.
Knowledge knowledge_of(const Eigen::VectorXd& column);

/// What the data cannot tell, a sentence each: parameters they leave open, pairs of which they tell
/// a combination only (correlation of 0.8 and more), and values that press against the end of their
/// range. Empty where all is told. `names` of the columns.
std::vector<std::string> what_is_not_told(const Posterior& posterior,
                                          const std::vector<std::string>& names);

}  // namespace encased_column
