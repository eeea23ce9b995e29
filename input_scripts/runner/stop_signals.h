// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <csignal>

namespace encased_column {

/// From its making on, Ctrl-C, SIGTERM, a closed terminal and SIGUSR1, which Slurm sends before the
/// time of a job ends, wait until they are asked for: none can come between two lines of this
/// program. A SIGHUP that was ignored before (nohup) stays
/// ignored.
class StopSignals {
 public:
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The signal that has come, or comes in `seconds`; 0 if none does. Returns early where a child
  /// ends.
  int wait(double seconds);

  int first() const { return first_; }  ///< that ever came, 0 if none did
  int count() const { return count_; }

 private:
  sigset_t awaited_;
  int first_ = 0, count_ = 0;
};

}  // namespace encased_column
