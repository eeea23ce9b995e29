#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

namespace encased_column {

/// Grows grains from a fraction of their radius to the full one, in stages.
class FixGrowRadius : public LAMMPS_NS::Fix {
 public:
  static const KeywordTable keywords;

  FixGrowRadius(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void initial_integrate(int) override;
  double max_rad(int type) override;
  double min_rad(int type) override;
  double compute_scalar() override { return factor_; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

 private:
  double start_;
  long stages_, steps_per_stage_;
  LAMMPS_NS::bigint begin_;
  double factor_;
};

}  // namespace encased_column
