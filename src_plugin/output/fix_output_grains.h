// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/vtk_files.h"
#include "files/vtk_series.h"
#include "host/contact_observer.h"
#include "host/output_files.h"
#include "host/run_clock.h"
#include "output/grain_track.h"

#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// `fix output/grains`: the group's grains as a time series that ParaView opens.
class FixOutputGrains : public LAMMPS_NS::Fix, public ContactObserver, public SeriesOwner {
 public:
  static const KeywordTable keywords;

  FixOutputGrains(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixOutputGrains() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_integrate() override;
  void end_of_step() override { write(); }
  int modify_param(int narg, char** arg) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override { contacts_of_.add(contact); }

  void grow_arrays(int capacity) override { track_.grow(capacity); }
  void copy_arrays(int from, int to, int) override { track_.copy(from, to); }
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override { return track_.pack(i, buffer); }
  int unpack_exchange(int i, double* buffer) override { return track_.unpack(i, buffer); }
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int) override { return 1 + GrainTrack::values_per_grain; }
  int maxsize_restart() override { return 1 + GrainTrack::values_per_grain; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;
  const VtkSeries* series() const override { return series_.get(); }
  double memory_usage() override { return track_.bytes(); }

 private:
  void read_keywords(int narg, char** arg);
  bool contacts_are_counted() const;
  GrainRecord record_of(int i) const;
  std::vector<GrainRecord> grains_of_all_ranks() const;
  void write();

  GrainFileOptions options_;
  double strain_range_ = 0.0;  ///< of neighbours [m], smaller than zero: by the grains' diameter
  OutputFiles files_;
  RunClock clock_;
  std::unique_ptr<VtkSeries> series_;  ///< used on the first rank only

  GrainTrack track_;
  bool written_ = false;  ///< since the fix was made
  // Set where the contact law asks, once per step and before the first contact of it.
  mutable LAMMPS_NS::bigint asked_step_ = -1;
  mutable ContactCounter contacts_of_;
};

}  // namespace encased_column
