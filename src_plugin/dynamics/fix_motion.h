// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/pair_list_timing.h"
#include "dynamics/grain_motion.h"
#include "dynamics/mass_scaling.h"
#include "dynamics/motion_settings.h"
#include "dynamics/unbalanced_force_ratio.h"
#include "host/contact_observer.h"
#include "host/force_start.h"
#include "host/grain_number_fix.h"
#include "host/ranks.h"
#include "host/velocity_watchers.h"

#include <optional>

namespace encased_column {

/// Moves the grains: central differences with local damping, a stable step found from the contact
/// stiffness of every grain, and density scaling when the deck sets the step.
class FixMotion : public MassScalingOwner,
                  public GrainNumberFix,
                  public ContactObserver,
                  public PairListTimingOwner {
 public:
  inline static const KeywordTable& keywords = MotionSettings::keywords;

  FixMotion(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override
  {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE | POST_RUN;
  }
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_force(int) override;
  void final_integrate() override;
  void post_run() override;
  double extend_cut_ghost() override { return PairListTiming::ghost_cutoff(lmp); }
  int pack_comm(int n, int* grains, double* buffer, int, int*) override
  {
    return list_timing.pack(n, grains, buffer);
  }
  void unpack_comm(int n, int first, double* buffer) override
  {
    list_timing.unpack(n, first, buffer);
  }
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override
  {
    if (n == 4) return damping_loss();
    const double values[] = {
        ratio_.average,  ratio_.maximum, found_.stable_step, found_.largest_factor, 0.0,
        ratio_.contacts, ratio_.bearing};
    return values[n];
  }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override
  {
    return stage_ == Stage::set_up || masses_ == Masses::wanted_in_step ||
           step % settings_.every == 0;
  }
  void add_contact(const Contact& contact) override;

  /// As of the last step that `every` divides.
  const UnbalancedForceRatio& unbalanced_ratio() const { return ratio_; }
  int every() const { return settings_.every; }
  /// Finds unbalanced_ratio() again, with the forces as they are now.
  void compute_unbalanced_ratio();
  /// Another local damping `alpha` [-] than that of the deck, until the run ends.
  void damp_run_with(double alpha)
  {
    complete_step();  // with the damping it was made with
    motion_.damping = alpha;
  }
  /// Inertial mass [kg] of grain i.
  double inertial_mass(int i) const { return mass_scaling.inertial_mass(i); }
  /// Work [J] of the local damping on all ranks since the fix was made.
  double damping_loss() const { return sum_over_ranks(motion_.loss, world); }

 private:
  /// A run is set up from its init() until its first step begins.
  enum class Stage { set_up, in_steps };
  /// Masses, step and ratio: known, or wanted before a step that `every` divides, as grains or
  /// materials are new. The same on all ranks once a step begins.
  enum class Masses { found, wanted_in_set_up, wanted_in_step };

  StepGrains grains() const;
  void admit_new_grains();
  void find_masses();
  void find_all_in_set_up();
  void complete_step() { motion_.complete_step(grains(), mass_scaling, update->dt); }
  void set_step();
  std::vector<double*> saved();

  MotionSettings settings_;
  GrainMotion motion_;
  VelocityWatchers watchers_;
  ForceStart force_start_;
  Stage stage_ = Stage::set_up;
  Masses masses_ = Masses::wanted_in_set_up;
  MassScaling::Rule found_with_;  ///< what masses and ratio were found with
  MassScaling::Found found_{0.0, 1.0};
  GrainLoads loads_;
  UnbalancedForceRatio ratio_;
  bool restored_made_grains_ = false;
  std::optional<double> time_of_restart_;  ///< until the first run after it [s]
};

}  // namespace encased_column
