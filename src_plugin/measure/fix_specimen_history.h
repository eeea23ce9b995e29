// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/csv_series.h"
#include "host/contact_observer.h"
#include "host/output_files.h"
#include "measure/specimen_sums.h"
#include "specimen/platens_of_deck.h"
#include "specimen/specimen.h"

#include <string>
#include <vector>

namespace encased_column {

class FixMotion;

/// Writes the curves of a test: a row of history.csv every N steps.
class FixSpecimenHistory : public LAMMPS_NS::Fix, public ContactObserver, public ContactLossOwner {
 public:
  static const KeywordTable keywords;
  static std::vector<TableText> tables();

  FixSpecimenHistory(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override { return batch_.at(n); }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  void start_sample();
  SpecimenMoment now();
  void add_grains();
  void check_grains(bool is_first);
  void take_sample();
  void write_row();

  Specimen specimen() const { return {platens_.now(), *side_}; }

  PlatensOfDeck platens_;
  NamedFix<LateralBoundary> side_;
  std::string motion_id_;
  FixMotion* motion_ = nullptr;

  LAMMPS_NS::bigint most_grains_ = 0;  ///< in any sample of this run
  bool setting_up_ = false;
  bool reference_wanted_ = false;
  ContactCounter contacts_of_;
  SpecimenSums sums_;
  SpecimenMoment before_;  ///< what strains, works and losses count from
  EnergyBalance balance_;
  std::vector<double> batch_;
  OutputFiles files_;
  CsvSeries file_;
};

}  // namespace encased_column
