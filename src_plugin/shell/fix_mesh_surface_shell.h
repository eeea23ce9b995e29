// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/contact_context.h"
#include "contact/contact_memory_fix.h"
#include "core/keyword_table.h"
#include "host/grains_and_box.h"
#include "host/ranks.h"
#include "shell/sleeve.h"
#include "specimen/lateral_boundary.h"
#include "specimen/platens_of_deck.h"

#include <array>
#include <memory>
#include <string>

namespace encased_column {

/// A sleeve around the specimen in two-way contact with the grains. Every rank knows all nodes;
/// facets and contacts are divided, and their loads summed once a step.
class FixMeshSurfaceShell : public ContactMemoryFix, public LateralBoundary {
 public:
  static const KeywordTable keywords;
  static constexpr int numbers = 18;  ///< of compute_vector()

  FixMeshSurfaceShell(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override { take_loads(false); }
  void final_integrate() override;
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  Vec3 axis() const override { return sleeve_->axis(); }
  double enclosed_volume(double z_low, double z_high) const override
  {
    return sleeve_->enclosed_volume({z_low, z_high});
  }
  double cross_section(double z) const override { return sleeve_->cross_section(z); }
  double radius_at(double z) const override { return sleeve_->radius_at(z); }
  double confining_stress() const override { return pressure_now(); }
  double work() const override
  {
    return sum_over_ranks(sleeve_->pressure_work(), world) + sleeve_->support_work();
  }
  double stored_energy() const override { return sum_over_ranks(sleeve_->energy(), world); }
  double kinetic_energy() const override { return model().kinetic_energy(); }
  double damping_loss() const override { return sleeve_->damping_loss(); }
  double yielding_loss() const override { return sum_over_ranks(sleeve_->dissipated(), world); }
  int count_outside(const double* centers, int count, double z_low, double z_high) const override
  {
    return sleeve_->count_outside(centers, count, {z_low, z_high});
  }

  const ShellModel& model() const { return sleeve_->model(); }
  /// Makes what the facets remember known on every rank, which all must call.
  void share_memory() { sleeve_->share_memory(AllRanks{world}); }
  /// Between the platens [m].
  HeightWindow window() const { return platens_.window(); }
  double pressure_now() const { return sleeve_->pressure(update->ntimestep); }
  SleeveSummary summary()
  {
    share_memory();
    return summary_of(model(), window());
  }
  /// What the supports of an end take along z, on the sleeve [N].
  double axial_force(bool top) const { return sleeve_->axial_force(top); }
  /// Vertical force of all grains on the sleeve [N]; the same on every rank.
  double friction_force() const { return sum_over_ranks(sleeve_->vertical_force(), world); }

 private:
  /// The grains of its group, as the sleeve looks at them.
  struct GrainsOfGroup {
    FixMeshSurfaceShell& fix;
    const GrainArrays& arrays;
    const double* centers = arrays.x;
    const double* radii = arrays.radius;

    bool counts(int i) const { return fix.atom->mask[i] & fix.groupbit; }
    /// Inline, as what it calls: a call that returns nothing would be left out.
    [[gnu::always_inline]] void fetch(int n, int i) const
    {
      arrays.fetch_for_law(i);
      fix.context_.fetch_mass(i);
      __builtin_prefetch(fix.contact_memory(n), 1, 2);
    }
  };

  SleeveStep step_now() const { return {update->ntimestep, update->dt}; }
  void read_pressure(const Options& options);
  void take_loads(bool at_set_up);
  template <typename Batch>
  void press(Batch& batch, bool advance_memory);
  void finish_loads();

  PlatensOfDeck platens_;
  Options on_fix_line_;
  int type_ = 0;
  bool rolling_ = false;
  std::unique_ptr<Sleeve> sleeve_;
  ContactContext context_;
  ContactBatch batch_;
  RollingBatch rolling_batch_;
};

}  // namespace encased_column
