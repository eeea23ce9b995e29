// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "dynamics/unbalanced_force_ratio.h"
#include "host/host_types.h"

#include <string>

namespace encased_column {

/// `solve`: runs until the grains are in equilibrium.
class SolveCommand : private LAMMPS_NS::Pointers {
 public:
  static const KeywordTable keywords;

  explicit SolveCommand(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);

 private:
  void run_piece(long steps);
  void write_last_output();
  void go_on(LAMMPS_NS::bigint end);
  void report(const UnbalancedForceRatio& ratio, double limit, const std::string& which,
              long steps) const;
};

}  // namespace encased_column
