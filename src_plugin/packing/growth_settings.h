// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "packing/growth_control.h"

#include <optional>

namespace encased_column {

/// What a deck says of a growth.
struct GrowthSettings {
  static const KeywordTable keywords;

  double start = 1.0;              ///< radius over full radius [-]
  long stages = 100;               ///< of the volume
  long steps_per_stage = 50;       ///< likewise from one look at the stress to the next
  std::optional<GrowthGoal> goal;  ///< where there is a stress to be met

  /// Throws InputError.
  static GrowthSettings read(const Options& options);
};

}  // namespace encased_column
