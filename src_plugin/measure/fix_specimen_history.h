#pragma once

#include "core/keyword_table.h"
#include "host/contact_probe.h"
#include "measure/energy_account.h"
#include "measure/specimen_state.h"
#include "output/csv_series.h"

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

  FixSpecimenHistory(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  /// Sums over this rank's grains and contacts, then over the ranks.
  struct Sums {
    double grains, solid, shared, inertia, diameter, weight_height, mass;
    double elastic, kinetic, friction, rolling, dashpots;
    double core_solid, core_axial, core_radial;
    double ends, without_contact, with_one_contact;
  };

  /// Sums of Love-Weber products over the grains in the core [J].
  struct CoreStress {
    double axial = 0.0, radial = 0.0;
  };

  static const std::vector<std::string>& columns();
  void clear_sums();
  bool is_in_core(int i) const;
  void add_to_core(int i, const Vec3& lever, const Vec3& force);
  SpecimenState state() const;
  Sums sum_up();
  void check_grains(const Sums& sums);
  void take_sample();
  void take_reference();
  void write_row();
  void stop_writing() const;

  std::string platen_ids_[2], side_id_, motion_id_;
  FixServoPlaten* top_ = nullptr;
  FixServoPlaten* bottom_ = nullptr;
  SpecimenSide* side_ = nullptr;
  FixMotion* motion_ = nullptr;

  LAMMPS_NS::bigint most_grains_ = 0;  ///< in any sample of this run
  bool setting_up_ = false;
  bool reference_wanted_ = false;
  std::vector<int> contacts_of_;
  double shared_volume_ = 0.0, elastic_ = 0.0;
  CoreStress core_;

  SpecimenState reference_, now_;
  EnergyAccount energy_;
  EnergyBalance balance_;
  std::vector<double> row_;
  CsvSeries file_;
};

}  // namespace encased_column
