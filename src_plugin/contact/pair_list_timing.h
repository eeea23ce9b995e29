// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/grain_reach.h"
#include "host/host_types.h"

namespace encased_column {

/// Decides when lists are made: the host, by its own check of half a skin in every step, or we for
/// the time of a run, with a reach for each grain.
class PairListTiming {
 public:
  /// Before a run, when the host has made its lists. `motion` moves the grains.
  void take_over(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion);
  /// After it. Lists are made in the next step, if that comes without a set-up.
  void give_back(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion);
  /// The host has made its lists. Those of a set-up, and of a step that a restart file may be
  /// written of, look the same in a run that goes on from the file: speeds do not, half a step on.
  void start(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion, bool at_set_up);
  /// Asks the host for lists in this step where a grain has left its reach; none went further than
  /// `way` [m] in it.
  void ask(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion, double way);

  /// Of owned grains and ghosts [m]; null where the host decides.
  const double* reach() const { return ours_ ? account_.reach().data() : nullptr; }

 private:
  bool ours_ = false;
  ReachAccount account_;
};

/// The fix that moves the grains.
class PairListTimingOwner {
 public:
  virtual ~PairListTimingOwner() = default;
  const double* reach() const { return list_timing_.reach(); }

 protected:
  PairListTiming list_timing_;
};

/// For lists that are made now.
GrainReach grain_reach(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
