// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <vector>

namespace encased_column {

/// A fix that acts while a step is made or at its end, but does not read the velocities of the
/// grains there: `fix motion` need not complete them for it.
class IgnoresVelocity {
 protected:
  virtual ~IgnoresVelocity() = default;
};

/// True where a fix of the host acts at one of `stages` of a step, up to the fix `last` in the
/// deck's order; `motion` is the fix that asks.
bool others_act(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion, int stages,
                const LAMMPS_NS::Fix* last = nullptr);

/// Which fixes read the velocities of grains, and when. A fix that is not an IgnoresVelocity may do
/// so wherever it acts.
class VelocityWatchers {
 public:
  /// Before a run; `motion` is the fix that asks.
  void find(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion);
  /// In the middle of every step.
  bool look_always() const { return look_always_; }
  /// At the end of the step that is made.
  bool look_now(LAMMPS_NS::LAMMPS* lmp) const;

 private:
  bool look_always_ = false;
  std::vector<int> every_;  ///< steps
};

}  // namespace encased_column
