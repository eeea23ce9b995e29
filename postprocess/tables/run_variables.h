// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/case_run.h"

#include <string>
#include <vector>

namespace encased_column {

/// The variables that make `runs` what they are, with units, for the caption of a figure: "σ₃ 50 /
/// 100 kPa, E* 140 MPa, ..., set laboratory, resolution quick". Where the runs differ each value
/// stands once; what no run has is left out. Rate and porosity are those the runs went with, not
/// those that were asked for.
std::string run_variables(const std::vector<const CaseRun*>& runs);

}  // namespace encased_column
