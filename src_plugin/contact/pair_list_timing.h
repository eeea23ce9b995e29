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
  void start(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion, bool at_set_up);
  /// A step in which no grain went further than `way` [m]: asks the host for lists where its
  /// grains have left their reaches, or widens some.
  void ask(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion, double way);

  /// How far [m] ghosts are to come, but for the skin that the host adds.
  static double ghost_cutoff(LAMMPS_NS::LAMMPS* lmp);

  /// Null where the host decides.
  const ReachAccount* account() const { return ours_ ? &account_ : nullptr; }

  /// Reaches for ghosts, by the host's messages.
  int pack(int count, const int* grains, double* buffer) const
  {
    for (int n = 0; n < count; ++n) buffer[n] = account_.reach(grains[n]);
    return 1;  // number each
  }
  void unpack(int count, int first, const double* buffer)
  {
    for (int n = 0; n < count; ++n) account_.set_reach(first + n, buffer[n]);
  }

 private:
  bool ours_ = false;
  ReachAccount account_;
};

/// The fix that moves the grains.
class PairListTimingOwner {
 public:
  PairListTiming list_timing;

 protected:
  virtual ~PairListTimingOwner() = default;
};

}  // namespace encased_column
