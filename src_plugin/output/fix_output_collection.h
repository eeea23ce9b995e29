// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/vtk_series.h"
#include "host/output_files.h"
#include "host/velocity_watchers.h"

#include <string>
#include <vector>

namespace encased_column {

/// `fix output/collection`: one file that opens the series of several fixes together in ParaView.
class FixOutputCollection : public LAMMPS_NS::Fix, public IgnoresVelocity {
 public:
  static const KeywordTable keywords;

  FixOutputCollection(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }
  void init() override;
  void setup(int) override { write(); }
  void end_of_step() override;

 private:
  void find_parts();
  std::size_t listed() const;
  void write();

  OutputFiles files_;
  std::string file_;  ///< the absolute path
  std::vector<std::string> ids_;
  std::vector<const VtkSeries*> parts_;
  std::size_t written_ = 0;  ///< files listed in it
};

}  // namespace encased_column
