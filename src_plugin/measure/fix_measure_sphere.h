// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/csv_series.h"
#include "files/vtk_series.h"
#include "host/contact_observer.h"
#include "host/output_files.h"
#include "host/run_clock.h"
#include "host/velocity_watchers.h"
#include "measure/sphere_sampler.h"
#include "specimen/platens_of_deck.h"

#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// `fix measure/sphere`: porosity, coordination, stress and forces in balls that stand still or
/// follow the platens, as rows of a CSV file and points of VTK files.
class FixMeasureSphere : public LAMMPS_NS::Fix,
                         public ContactObserver,
                         public SeriesOwner,
                         public IgnoresVelocity {
 public:
  static const KeywordTable keywords;
  static std::vector<TableText> tables();

  FixMeasureSphere(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_array(int sphere, int column) override { return rows_[sphere][column]; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;
  const VtkSeries* series() const override { return series_.get(); }

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  void start_sample();
  void take_sample();
  void warn_of_few_grains(const std::vector<SphereRow>& samples);
  void write_row();
  void write_frame();

  SphereSampler sampler_;
  ContactCounter contacts_of_;
  PlatensOfDeck platens_;  ///< of the stack

  long row_every_ = 1, frame_every_ = 1;  ///< steps
  bool setting_up_ = false, warned_ = false, sampled_ = false;
  std::vector<std::vector<double>> rows_;  ///< of each sphere the last one

  OutputFiles files_;
  CsvSeries file_;
  RunClock clock_;
  std::unique_ptr<VtkSeries> series_;  ///< if VTK files are wanted
};

}  // namespace encased_column
