// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"
#include "shell/nodal_masses.h"
#include "shell/pressure_load.h"
#include "shell/sleeve_contacts.h"
#include "shell/sleeve_end.h"
#include "shell/sleeve_record.h"
#include "shell/sleeve_state.h"
#include "shell/sleeve_watch.h"
#include "shell/touched_nodes.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// What a deck may change of a sleeve from run to run.
struct SleeveControl {
  std::array<SleeveEnd, 2> ends{SleeveEnd::held, SleeveEnd::held};  ///< top, bottom
  bool rigid = false;               ///< stands still and bears any load
  bool pressed_everywhere = false;  ///< else between the platens
  double damping = 0.7;             ///< local damping alpha [-]
  double strain_limit = 0.5;        ///< [-]
  bool stops_when_torn = true;      ///< the run ends at the first facet that is torn through
};

/// The part of a machine that a sleeve is on: nodes are known to all, facets are divided.
struct Rank {
  int number = 0, count = 1;
};

/// A deformable sleeve around a specimen: mesh, material, masses, ends, the pressure from outside
/// and the contacts with grains.
///
/// A step is advance(); start_loads(); press_grains(); finish_loads(). A set-up is the last three.
/// `ranks` adds up numbers of all ranks in place, `sum(numbers, count)`, and makes them known to
/// each, `gather` as TouchedNodes asks for it. No step allocates memory.
class Sleeve {
 public:
  /// Throws InputError where the mesh is no upright sleeve, or for a material without energy.
  Sleeve(const SurfaceMesh& mesh, const ShellConstants& constants, const NodalMassRule& rule,
         Rank rank = {});

  const SleeveControl& control() const { return control_; }
  void set_control(const SleeveControl& control, long step);
  /// The pressure heads for `target` [Pa] over `steps` steps.
  void set_pressure(double target, long steps, long now) { pressure_.set(target, steps, now); }
  double pressure(long step) const { return pressure_.at(step); }
  long ramp_left(long step) const { return pressure_.steps_left(step); }

  /// Moves the nodes; the platens go inwards with these speeds [m/s], the top one first.
  void advance(double dt, const std::array<double, 2>& platen_speeds);
  /// Takes the loads of its facets and of the pressure, on what lies in `window`.
  void start_loads(const SleeveStep& step, const HeightWindow& window, bool at_set_up);

  /// True once the list below must be made again.
  bool needs_list() const { return contacts_.is_stale(model_); }
  /// Lists the grains near by, see SleeveContacts::list(), or those whose reach got wider in
  /// addition where `anew` is false, at the same step on all ranks; returns their numbers.
  template <typename Ranks>
  const std::vector<int>& list_grains(const double* centers, const double* radii, int grains,
                                      const GrainReach& reach, bool anew, const Ranks& ranks)
  {
    if (anew)
      contacts_.list(model_, centers, radii, grains, reach);
    else
      contacts_.add_wider(model_, centers, radii, grains, reach);
    if (rank_.count > 1) touched_.list(model_.facet(), first_, last_, contacts_.facets(), ranks);
    return contacts_.grains();
  }
  bool has_grains_near() const { return !contacts_.grains().empty(); }
  /// Takes the loads of the grains, see SleeveContacts::resolve().
  template <typename Grains, typename Law>
  std::optional<GrainBehind> press_grains(const Grains& grains, const Law& law)
  {
    const auto behind =
        contacts_.resolve(model_, !control_.rigid, grains, masses_.contact_bound(), law);
    vertical_force_ = contacts_.vertical_force();
    return behind;
  }
  /// Adds the loads up and finds the masses where it is time to. Throws InputError where the step
  /// is too long for true masses.
  template <typename Ranks>
  void finish_loads(const SleeveStep& step, const Ranks& ranks)
  {
    if (control_.rigid) return;
    if (rank_.count > 1) touched_.sum(model_.load(), ranks);
    damping_loss_ += masses_.finish(model_, first_, last_, step, ranks);
  }
  /// What the supports bear of the loads as they stand, for what looks before the first step.
  void find_reactions();

  /// What is wrong with the facets of this rank; looked for where `is_time_to_check`.
  bool is_time_to_check(long step) const;
  std::optional<std::string> fault(long step) const;
  /// The sentence for a grain that is behind the sleeve, `tag` to the user.
  std::string sentence_of(const GrainBehind& behind, long tag, const std::string& id,
                          long step) const;
  /// What the log is to be told, each thing once.
  std::vector<std::string> warnings(const HeightWindow& window, const std::string& id,
                                    const std::array<std::string, 2>& platens, long step);

  const ShellModel& model() const { return model_; }
  const Vec3& axis() const { return axis_; }  ///< a point of the center line [m]
  double enclosed_volume(const HeightWindow& window) const;
  double cross_section(double z) const;                                          ///< [m^2]
  double radius_at(double z) const { return std::sqrt(cross_section(z) / pi); }  ///< mean [m]
  /// How many of `count` centers in a row of triples [m] are not inside, within the window.
  int count_outside(const double* centers, int count, const HeightWindow& window) const;
  double axial_force(bool top) const;  ///< on the sleeve by the supports of an end, along z [N]
  double mass_factor() const { return masses_.factor(); }

  // Of this rank alone:
  double energy() const { return energy_; }                  ///< elastic [J]
  double vertical_force() const { return vertical_force_; }  ///< of the grains on the sleeve [N]
  double pressure_work() const { return pressure_work_; }    ///< [J]
  /// What yielding and tearing took [J].
  double dissipated() const { return model_.cloth().dissipated(); }
  // The same on every rank:
  double support_work() const { return support_work_; }  ///< [J]
  double damping_loss() const { return damping_loss_; }  ///< with what rising masses took [J]

  /// True where facets remember what other ranks do not know of them.
  bool remembers() const { return model_.cloth().remembers(); }
  /// Makes the memory of all facets known here, for summaries and files.
  template <typename Ranks>
  void share_memory(const Ranks& ranks)
  {
    if (rank_.count == 1 || !remembers()) return;
    std::vector<double> numbers = memory_numbers(model_, first_, last_);
    ranks.sum(numbers.data(), numbers.size());
    take_memory(model_, numbers);
  }

  /// All that a run needs to go on bit by bit; the energies [J] are those of all ranks, and so must
  /// the memory of the facets be.
  std::vector<double> state(double pressure_work, double dissipated) const;
  /// Throws InputError where the numbers are of another mesh.
  void restore(const std::vector<double>& state);

 private:
  void require_upright() const;
  void place_supports();
  double level_inside(double z) const;
  long steps_since_release(long step) const { return released_ < 0 ? -1 : step - released_; }

  Rank rank_;
  ShellModel model_;
  std::vector<std::array<int, 2>> pairs_;  ///< neighbouring facets
  std::vector<int> end_nodes_[2];          ///< top, bottom
  std::size_t first_bottom_support_ = 0;
  Vec3 axis_ = Vec3::Zero();
  int first_, last_;  ///< facets of this rank

  SleeveControl control_;
  PressureRamp pressure_{0.0};
  long released_ = -1;  ///< step of the release from being rigid, below 0: none
  SleeveContacts contacts_;
  TouchedNodes touched_;

  NodalMasses masses_;
  double energy_ = 0.0, pressure_work_ = 0.0, vertical_force_ = 0.0;
  double support_work_ = 0.0, damping_loss_ = 0.0;
  SleeveWatch watch_;
};

}  // namespace encased_column
