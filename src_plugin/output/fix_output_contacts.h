// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/csv_series.h"
#include "files/vtk_files.h"
#include "files/vtk_series.h"
#include "host/contact_observer.h"
#include "host/output_files.h"
#include "host/run_clock.h"
#include "output/contact_columns.h"

#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// `fix output/contacts`: contacts as lines that ParaView opens, and what their forces are on the
/// whole as rows of a CSV file.
class FixOutputContacts : public LAMMPS_NS::Fix, public ContactObserver, public SeriesOwner {
 public:
  static const KeywordTable keywords;
  static std::vector<TableText> tables();

  FixOutputContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_vector(int n) override { return batch_[n]; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;
  const VtkSeries* series() const override { return series_.get(); }

 private:
  bool is_seen_elsewhere(const Contact& contact) const;
  bool wants_frame() const;
  void clear_contacts();
  void write_row();
  void write_frame();

  long frame_every_ = 0, row_every_ = 0;
  double threshold_ = 0.0;  ///< of the VTK files [N]
  bool first_forces_ = false, written_ = false;
  std::vector<ContactRecord> contacts_;  ///< of this rank, for a VTK file
  ContactForces forces_;                 ///< of this rank, then of all
  std::vector<double> batch_;

  OutputFiles files_;
  RunClock clock_;
  CsvSeries file_;
  std::unique_ptr<VtkSeries> series_;
};

}  // namespace encased_column
