#pragma once

#include "core/keyword_table.h"
#include "dynamics/kick_grains.h"
#include "dynamics/mass_scaling.h"
#include "dynamics/unbalanced_force_ratio.h"
#include "host/contact_probe.h"

#include <limits>
#include <optional>
#include <vector>

namespace encased_column {

/// Moves the grains: central differences with local damping, a stable step found from the contact
/// stiffness of every grain, and density scaling when the deck sets the step.
class FixMotion : public LAMMPS_NS::Fix, public ContactProbe, public MassScalingOwner {
 public:
  static const KeywordTable keywords;

  FixMotion(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixMotion() override;

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_force(int) override;
  void final_integrate() override;
  void post_run() override;
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override;

  void grow_arrays(int n) override;
  void copy_arrays(int from, int to, int delete_flag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int) override { return 2; }
  int maxsize_restart() override { return 2; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

  /// As of the last step that `every` divides.
  const UnbalancedForceRatio& unbalanced_ratio() const { return equilibrium_; }
  int every() const { return every_; }
  /// Finds unbalanced_ratio() anew, with the forces as they are now.
  void compute_unbalanced_ratio();
  /// Inertial mass [kg] of grain i.
  double inertial_mass(int i) const { return mass_scaling.inertial_mass(i); }
  /// Work [J] of the local damping on all ranks since the fix was made.
  double damping_loss() const;

 private:
  void read_free_speed(const Options& options);
  GrainRow row(int first, int count) const;
  template <typename Kick>
  void for_rows(const Kick& kick) const;
  void find_onlookers();
  bool is_looked_at() const;  ///< the end of this step
  void finish_step();
  bool others_act(int stages, const LAMMPS_NS::Fix* last) const;
  void take_over_sums();
  void start_sums(int first, int count);
  /// To the free speed those of `count` grains that are faster and touch nothing.
  void slow_down(int first, int count);
  void collect();
  std::vector<int> types_that_count() const;
  void set_masses();
  void admit_new_grains();
  void set_step();

  /// The state in a restart file.
  struct Saved {
    double time, loss, largest_factor, stable_step;
    UnbalancedForceRatio equilibrium;
    MassScaling::Rule rule;
    bool anew;
  };

  void look_anew();
  MovingGrains moving_grains() const;

  double damping_;
  int every_;
  double free_speed_square_ = std::numeric_limits<double>::infinity();  ///< [m^2/s^2]
  Vec3 gravity_ = Vec3::Zero();                                         ///< [m/s^2]
  bool setting_up_ = false;
  /// Grains or materials are new to this fix: it finds inertia and equilibrium when it is set up,
  /// and does not wait for the next step that `every` divides.
  bool anew_ = true;
  bool made_grains_ = false;               ///< on this rank, since forces were last made
  bool weighs_new_grains_ = false;         ///< in this step, on all ranks
  MassScaling::Rule found_with_;           ///< what masses and equilibrium were found with
  std::optional<double> time_of_restart_;  ///< until the first run after it [s]
  double contact_force_sum_ = 0.0, contact_count_ = 0.0;
  double loss_ = 0.0;
  /// The last half kick of the step is still to come, with the first one of the next.
  bool unfinished_ = false;
  bool always_looked_at_ = false;
  /// Sums of force and moment start here, not in the host: with the weight, in the pass over the
  /// grains that has done with the old ones.
  bool starts_sums_ = false;
  bool sums_started_ = false;  ///< for the step to come
  bool takes_weight_ = false;
  std::vector<int> looked_at_every_;  ///< steps
  double largest_factor_ = 1.0, stable_step_ = 0.0;
  UnbalancedForceRatio equilibrium_;
};

}  // namespace encased_column
