// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/contact_observer.h"
#include "host/find_fix.h"
#include "host/friction_factor.h"
#include "host/host_types.h"
#include "packing/growth_settings.h"
#include "specimen/platens_of_deck.h"
#include "specimen/specimen.h"

namespace encased_column {

class FixMotion;

/// Grows grains from a fraction of their radius to the full one, in stages; with a stress to be
/// met, as far as the grains give way.
class FixGrowRadius : public LAMMPS_NS::Fix, public ContactObserver, public FrictionFactorOwner {
 public:
  inline static const KeywordTable& keywords = GrowthSettings::keywords;

  FixGrowRadius(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override { start_sums(); }
  void pre_force(int) override { start_sums(); }
  void initial_integrate(int) override;
  double max_rad(int type) override;
  double min_rad(int type) override;
  double compute_scalar() override { return factor_; }
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  void find_specimen();
  void start_sums();
  /// Of the specimen, on all ranks together.
  PackingState look();
  void decide();
  void report_end();
  void grow_to(double factor);
  double volume() const;
  /// With the solid volume `solid` over that at full size; 0 for none.
  double porosity_at(double solid) const;

  GrowthSettings settings_;
  LAMMPS_NS::bigint begin_;
  double factor_;
  std::optional<GrowthControl> control_;  ///< where there is a stress to be met
  PlatensOfDeck platens_;
  NamedFix<LateralBoundary> side_;
  const FixMotion* motion_ = nullptr;
  ContactSums sums_;    ///< of this rank, of the last step at which contacts were wanted
  PackingState found_;  ///< at the last look
};

}  // namespace encased_column
