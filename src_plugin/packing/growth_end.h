// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "packing/growth_control.h"

#include <string>

namespace encased_column {

/// How a growth ended, with what a reader of the log wants to know of it.
struct GrowthEnd {
  GrowthControl::Stage stage;
  GrowthGoal goal;
  PackingState found;       ///< at the last look
  double friction_factor;   ///< [-]
  double porosity;          ///< now [-]
  double at_full_size;      ///< porosity that was drawn [-]
  double loosest, densest;  ///< porosities of GrowthControl, 0 where not found [-]

  /// True where the run may go on with the packing.
  bool is_good() const;
  /// One sentence: for the log where it is good, else what is to be written instead.
  std::string in_words() const;
};

}  // namespace encased_column
