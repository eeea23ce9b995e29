// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/case_size.h"

#include <optional>

namespace encased_column {

/// The shape of a case as its deck, its variables and the files they name tell it. Nothing for a
/// deck that tells too little: no create_packing, or no `height`, `rate` and `strain_end`.
std::optional<CaseShape> case_shape(const CasePlan& plan);

/// The size of a case, if its deck tells it.
std::optional<CaseSize> expected_size(const CasePlan& plan);

}  // namespace encased_column
