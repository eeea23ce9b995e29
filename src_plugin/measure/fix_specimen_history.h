#pragma once

#include "core/keyword_table.h"
#include "files/csv_series.h"
#include "host/contact_counter.h"
#include "host/output_files.h"
#include "measure/specimen_columns.h"

#include <string>
#include <vector>

namespace encased_column {

class FixMotion;
class FixServoPlaten;
class SpecimenSide;

/// Writes the curves of a test: a row of history.csv every N steps.
class FixSpecimenHistory : public LAMMPS_NS::Fix, public ContactProbe, public ContactLossOwner {
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
  double compute_vector(int n) override { return row_.at(n); }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  void start_sample();
  SpecimenMoment now();
  void add_grains();
  void check_grains();
  void take_sample();
  void write_row();

  std::string platen_ids_[2], side_id_, motion_id_;
  FixServoPlaten* top_ = nullptr;
  FixServoPlaten* bottom_ = nullptr;
  SpecimenSide* side_ = nullptr;
  FixMotion* motion_ = nullptr;

  LAMMPS_NS::bigint most_grains_ = 0;  ///< in any sample of this run
  bool setting_up_ = false;
  bool reference_wanted_ = false;
  ContactCounter contacts_of_;
  SpecimenSums sums_;
  SpecimenMoment before_;  ///< what strains, works and losses count from
  std::vector<double> row_;
  OutputFiles files_;
  CsvSeries file_;
};

}  // namespace encased_column
