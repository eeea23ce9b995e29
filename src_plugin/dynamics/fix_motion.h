#pragma once

#include "core/keyword_table.h"
#include "dynamics/equilibrium.h"
#include "dynamics/kick_grains.h"
#include "dynamics/stable_step.h"
#include "host/contact_probe.h"
#include "host/inertia_owner.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace encased_column {

/// Moves the grains: central differences with local damping, a stable step found from the contact
/// stiffness of every grain, and density scaling when the deck sets the step.
class FixMotion : public LAMMPS_NS::Fix, public ContactProbe, public InertiaOwner {
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
  const Equilibrium& equilibrium() const { return equilibrium_; }
  int every() const { return every_; }
  /// Finds equilibrium() anew, with the forces as they are now.
  void weigh_equilibrium();
  /// Inertial mass [kg] of grain i.
  double inertial_mass(int i) const { return inertia_[i]; }
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
  void set_inertia();
  void bear_first_contacts();

  /// What inertia, apart from the contacts, and the weighing were found with.
  struct Rule {
    double fixed_step, safety, stiffest_material;
    bool rolling;
    bool operator==(const Rule& other) const;
  };
  /// The state in a restart file.
  struct Saved {
    double time, loss, largest_factor, stable_step;
    Equilibrium equilibrium;
    Rule rule;
    bool anew, made_grains;
  };

  Rule rule_now() const { return {scaled_step_, safety_, stiffest_material_, rolling_}; }
  void look_anew();
  void make_heavier(int i, double inertia) override;
  /// A grain before `end`, and after those whose momentum was kept, got heavier in this step.
  bool gets_heavier_before(int end) const
  {
    return slowed_ < heavier_.size() && heavier_[slowed_].first < end;
  }
  /// Of grains before `end` that got heavier, in the order of the list.
  void keep_momentum(int end = std::numeric_limits<int>::max());
  double kinetic_energy_of(int i) const;

  double damping_;
  int every_;
  double free_speed_square_ = std::numeric_limits<double>::infinity();  ///< [m^2/s^2]
  Vec3 gravity_ = Vec3::Zero();                                         ///< [m/s^2]
  double stiffest_material_ =
      0.0;  ///< E* [Pa] of the contact of grains that needs the smallest step
  bool setting_up_ = false;
  /// Grains or materials are new to this fix: it finds inertia and equilibrium when it is set up,
  /// and does not wait for the next step that `every` divides.
  bool anew_ = true;
  bool made_grains_ = false;        ///< on this rank, since forces were last made
  bool weighs_new_grains_ = false;  ///< in this step, on all ranks
  bool restored_made_grains_ = false;
  Rule rule_{};
  std::optional<double> time_of_restart_;  ///< until the first run after it [s]
  std::vector<GrainStiffness> stiffness_;
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
  /// Grains that got heavier in this step, each with its mass before over that after.
  std::vector<std::pair<int, double>> heavier_;
  std::size_t slowed_ = 0;  ///< of them already
  double largest_factor_ = 1.0, stable_step_ = 0.0;
  Equilibrium equilibrium_;
};

}  // namespace encased_column
