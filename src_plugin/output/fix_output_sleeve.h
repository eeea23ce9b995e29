// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/column.h"
#include "files/csv_series.h"
#include "files/vtk_series.h"
#include "host/output_files.h"
#include "host/run_clock.h"
#include "host/velocity_watchers.h"
#include "shell/sleeve_profile.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

class FixMeshSurfaceShell;

/// `fix output/sleeve`: a sleeve as a time series that ParaView opens, its profile over the height
/// at the same times, and its curves.
class FixOutputSleeve : public LAMMPS_NS::Fix, public SeriesOwner, public IgnoresVelocity {
 public:
  static const KeywordTable keywords;
  static std::vector<TableText> tables();

  FixOutputSleeve(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;
  const VtkSeries* series() const override { return series_.get(); }

 private:
  double height() const;
  double axial_strain() const { return 1.0 - height() / height_before_; }
  void write_curves();
  void write_frame();

  std::string sleeve_id_;
  FixMeshSurfaceShell* sleeve_ = nullptr;
  long frame_every_ = 0, row_every_ = 0;
  OutputFiles files_;
  RunClock clock_;
  std::unique_ptr<VtkSeries> series_;
  CsvSeries profile_, curves_;
  std::optional<SleeveRings> rings_;
  std::vector<Vec3> before_;  ///< positions that displacements count from [m]
  double height_before_ = 0.0;
};

}  // namespace encased_column
