// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"
#include "host/velocity_watchers.h"

namespace encased_column {

/// What a signal asks of a run. The host's own handlers change flags that it reads at any moment,
/// on each rank by itself: ranks that got a signal in different steps would leave the run in
/// different steps, and wait for one another for ever. Here a request is kept until all ranks are
/// at the same place of a step, and becomes the host's then (FixStopRequest).
struct StopRequest {
  static constexpr int stop = 1, save = 2;
};

/// From now on Ctrl-C, SIGTERM, a closed terminal and SIGUSR2, which mpirun passes on, ask to stop
/// at a step, with a restart file; SIGUSR1 asks for the file alone. A second signal to stop ends
/// the program at once.
void install_stop_handlers();

/// What has been asked for since this rank's last call: a sum of the numbers above.
int take_request();

/// Stands first in every run, unseen by the deck: gives the host a request of signals
/// at a step on which all ranks agree.
class FixStopRequest : public LAMMPS_NS::Fix, public IgnoresVelocity {
 public:
  using Fix::Fix;

  /// Puts one into the run of `lmp` unless it has one; takes a box.
  static void add_to(LAMMPS_NS::LAMMPS* lmp);

  int setmask() override;
  void initial_integrate(int) override;
};

}  // namespace encased_column
