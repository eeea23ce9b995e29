// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/number_row.h"
#include "shell/shell_model.h"

#include <vector>

namespace encased_column {

/// How the masses of the nodes are found.
struct NodalMassRule {
  bool scaled = true;   ///< as heavy as the step asks for; else the true ones
  double safety = 0.8;  ///< fraction of the step sqrt(m/k) [-]
  int every = 50;       ///< [steps]
};

/// A step, or its set-up, which repeats the forces of the one before.
struct SleeveStep {
  long number;
  double length;  ///< [s]
};

/// The masses of a sleeve's nodes: from time to time raised to what the step asks for, or the step
/// refused. Bounds of the facets' stiffness are kept for a while, those of contacts found each
/// time.
class NodalMasses {
 public:
  explicit NodalMasses(const NodalMassRule& rule) : rule_(rule) {}
  const NodalMassRule& rule() const { return rule_; }
  double factor() const { return factor_; }  ///< mass of the sleeve over its true mass [-]
  bool are_of_a_step() const { return step_length_ != 0.0; }

  /// Decides whether this step looks at masses. A set-up leaves those that were made for this
  /// length of step as they are; the release of a rigid sleeve starts from the true ones.
  void start(const SleeveStep& step, bool at_set_up, bool rigid, int nodes);
  /// Where contacts of this step put their stiffness; null where nobody asks.
  std::vector<StiffnessBound>* contact_bound() { return updates_ ? &contact_bound_ : nullptr; }
  /// Finds the masses where it is time to, `ranks.sum(numbers, count)` adds up over the ranks that
  /// share the facets, of which this one has [first, last); returns the energy [J] that rising
  /// masses take. Throws InputError where the step is too long for true masses.
  template <typename Ranks>
  double finish(ShellModel& model, int first, int last, const SleeveStep& step, const Ranks& ranks)
  {
    if (!updates_) return 0.0;
    if (find_facet_bound(model, first, last, step))
      ranks.sum(&facet_bound_.front().translation, 2 * facet_bound_.size());
    ranks.sum(&contact_bound_.front().translation, 2 * contact_bound_.size());
    return update(model, step);
  }

  void save(std::vector<double>& numbers) const;
  void restore(NumberRow& numbers);
  void save_bounds(std::vector<double>& numbers) const;
  void restore_bounds(NumberRow& numbers, int nodes);

 private:
  bool find_facet_bound(const ShellModel& model, int first, int last, const SleeveStep& step);
  double update(ShellModel& model, const SleeveStep& step);

  NodalMassRule rule_;
  std::vector<StiffnessBound> facet_bound_;  ///< empty: not known yet
  std::vector<StiffnessBound> contact_bound_;
  bool bounds_are_saved_ = false;  ///< in the row that is being restored
  bool updates_ = false;           ///< in this step
  double step_length_ = 0.0;       ///< that the masses were made for [s], 0: none
  double factor_ = 1.0;
};

}  // namespace encased_column
