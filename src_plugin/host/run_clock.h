// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <optional>

namespace encased_column {

/// Time since the first run of a deck, across restarts: the host restarts at the step but, once a
/// run begins, at time zero.
class RunClock {
 public:
  explicit RunClock(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// In setup().
  void begin_run()
  {
    if (of_restart_) before_ = *of_restart_ - lmp_->update->get_cur_time();
    of_restart_.reset();
  }
  /// Goes on at `time` [s].
  void restart(double time) { of_restart_ = time; }
  double now() const  ///< [s]
  {
    return of_restart_ ? *of_restart_ : before_ + lmp_->update->get_cur_time();
  }

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  std::optional<double> of_restart_;  ///< until the first run after it [s]
  double before_ = 0.0;               ///< of the runs before a restart [s]
};

/// In the set-up of the first run after a restart: the host goes on at the step of the file, but at
/// time zero.
inline void resume_time(LAMMPS_NS::LAMMPS* lmp, std::optional<double>& time_of_restart)
{
  if (!time_of_restart) return;
  lmp->update->atime = *time_of_restart;
  lmp->update->atimestep = lmp->update->ntimestep;
  time_of_restart.reset();
}

}  // namespace encased_column
