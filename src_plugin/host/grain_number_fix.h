// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <vector>

namespace encased_column {

/// A fix that keeps one number with each grain: through moves, to other ranks, in restart files.
class GrainNumberFix : public LAMMPS_NS::Fix {
 public:
  /// `numbers`, which lives as long as the fix, gets a place for each grain; new ones get zero.
  GrainNumberFix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, std::vector<double>& numbers);
  ~GrainNumberFix() override;

  void grow_arrays(int n) override;
  void copy_arrays(int from, int to, int delete_flag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int) override { return 2; }
  int maxsize_restart() override { return 2; }

 protected:
  bool made_grains_ = false;  ///< on this rank, since the fix set it to false

 private:
  std::vector<double>& numbers_;
};

}  // namespace encased_column
