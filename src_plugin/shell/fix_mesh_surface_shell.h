#pragma once

#include "contact/contact_desk.h"
#include "core/keyword_table.h"
#include "host/contact_memory_fix.h"
#include "shell/pressure_load.h"
#include "shell/sleeve_contacts.h"
#include "shell/sleeve_end.h"
#include "shell/sleeve_state.h"
#include "specimen/lateral_boundary.h"
#include "specimen/platens_of_deck.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// A deformable sleeve around the specimen: shell elements in two-way contact with the grains, a
/// pressure from outside, ends held in one of several ways. Every rank knows all nodes; facets and
/// contacts are divided, and their loads summed once a step.
class FixMeshSurfaceShell : public ContactMemoryFix, public LateralBoundary {
 public:
  static const KeywordTable keywords;

  FixMeshSurfaceShell(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override { take_loads(true); }
  void final_integrate() override;
  int modify_param(int narg, char** arg) override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  Vec3 axis() const override { return axis_; }
  double enclosed_volume(double z_low, double z_high) const override;
  double cross_section(double z) const override;
  double radius_at(double z) const override;
  double confining_stress() const override { return pressure_now(); }
  double work() const override;
  double stored_energy() const override;
  double kinetic_energy() const override;
  double damping_loss() const override { return damping_loss_; }
  int count_outside(const double* centers, int count, double z_low, double z_high) const override;

  const ShellModel& model() const { return *model_; }
  /// Between the platens [m].
  HeightWindow window() const { return platens_.window(); }
  double pressure_now() const { return pressure_.at(update->ntimestep); }
  SleeveSummary summary() const { return summary_of(*model_, window()); }
  /// What the supports of an end take along z, on the sleeve [N].
  double axial_force(bool top) const;
  /// Vertical force of all grains on the sleeve [N]; the same on every rank.
  double friction_force() const;

 private:
  void read_mesh(const Options& options);
  void read_weighing(const Options& options);
  void require_upright(const SurfaceMesh& mesh) const;
  void read_material(const Options& options);
  void read_changeable(const Options& options);
  void read_pressure(const Options& options);
  void place_supports();

  void take_loads(bool advance_memory);
  void press_grains(bool advance_memory);
  template <bool rolling>
  void press(bool advance_memory);
  void close_loads();
  void weigh();
  void check();
  void warn_of_platens_outside();
  void warn_of_rupture();
  void warn(const std::string& sentence);
  double level_inside(double z) const;

  PlatensOfDeck platens_;
  std::unique_ptr<ShellModel> model_;
  ShellConstants constants_;
  std::vector<std::array<int, 2>> pairs_;  ///< neighbouring facets
  std::vector<int> end_nodes_[2];          ///< top, bottom
  SleeveEnd ends_[2] = {SleeveEnd::held, SleeveEnd::held};
  std::size_t first_bottom_support_ = 0;
  Vec3 axis_ = Vec3::Zero();
  int first_ = 0, last_ = 0;  ///< facets of this rank

  int type_ = 0;
  bool rigid_ = false, everywhere_ = false, scale_masses_ = true, rolling_ = false;
  double damping_ = 0.7, safety_ = 0.8, strain_limit_ = 0.5, rupture_ = 0.0;
  int every_ = 50;
  bool rupture_told_ = false, platen_told_[2] = {false, false};
  PressureRamp pressure_{0.0};
  Options on_fix_line_;

  ContactDesk desk_;
  SleeveContacts contacts_;
  std::vector<StiffnessBound> facet_bound_, contact_bound_;
  bool weighing_ = false;
  double weighed_step_ = 0.0;  ///< length of the step the masses were made for [s]
  double mass_factor_ = 1.0;
  double energy_ = 0.0;         ///< of this rank's facets [J]
  double pressure_work_ = 0.0;  ///< of this rank's facets [J]
  double support_work_ = 0.0, damping_loss_ = 0.0;
  double vertical_force_ = 0.0;  ///< of this rank's grains on the sleeve [N]
};

}  // namespace encased_column
