// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// Three sentences, a line each: how many of agreement_numbers() `sets` have met, which they have
/// not, and how their checks ended. Two where there is nothing to compare with.
std::string result_sentences(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
