// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

namespace encased_column {

/// `require`: refuses a deck's variable that is out of its range before anything is run.
class RequireCommand : private LAMMPS_NS::Pointers {
 public:
  static const KeywordTable keywords;

  explicit RequireCommand(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);
};

}  // namespace encased_column
