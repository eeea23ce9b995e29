// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

namespace encased_column {

/// `record_variables`: writes the variables a deck has, as the host knows them.
class RecordVariablesCommand : private LAMMPS_NS::Pointers {
 public:
  static const KeywordTable keywords;

  explicit RecordVariablesCommand(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);
};

}  // namespace encased_column
