// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/output_files.h"
#include "host/velocity_watchers.h"

#include <string>

namespace encased_column {

/// `fix output/restart`: one restart file that is whole at any moment, whatever ends the run.
class FixOutputRestart : public LAMMPS_NS::Fix, public IgnoresVelocity {
 public:
  static const KeywordTable keywords;

  FixOutputRestart(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void pre_exchange() override;
  void end_of_step() override;
  void post_run() override;

 private:
  void check_order() const;
  void plan();
  bool is_old() const;
  void write();

  OutputFiles files_;
  std::string file_;  ///< the absolute path
  LAMMPS_NS::bigint written_step_ = -1;
};

}  // namespace encased_column
