#pragma once

#include "core/keyword_table.h"
#include "host/contact_probe.h"
#include "measure/energy_account.h"
#include "output/csv_series.h"
#include "specimen/platens_of_deck.h"
#include "specimen/specimen.h"

#include <string>
#include <vector>

namespace encased_column {

class FixMotion;

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
  bool is_in_core(int i) const { return core_heights_.holds(atom->x[i][2]); }
  void add_to_core(int i, const Vec3& lever, const Vec3& force);
  Sums sum_up();
  void check_grains(const Sums& sums);
  void take_sample();
  void take_reference();
  void write_row();
  void stop_writing() const;

  Specimen specimen() const { return {platens_.now(), *side_}; }

  PlatensOfDeck platens_;
  NamedFix<LateralBoundary> side_;
  std::string motion_id_;
  FixMotion* motion_ = nullptr;

  LAMMPS_NS::bigint most_grains_ = 0;  ///< in any sample of this run
  bool setting_up_ = false;
  bool reference_wanted_ = false;
  std::vector<int> contacts_of_;
  double shared_volume_ = 0.0, elastic_ = 0.0;
  HeightWindow core_heights_;  ///< of this sample
  CoreStress core_;

  SpecimenState reference_, now_;
  EnergyAccount energy_start_, energy_;
  std::vector<double> row_;
  CsvSeries file_;
};

}  // namespace encased_column
