#pragma once

namespace encased_column {

/// What a signal asks of a run. The host's own handlers change flags that it reads at any moment,
/// on each rank by itself: ranks that hear of a signal in different steps would leave the run in
/// different steps, and wait for one another for ever. Here a request is kept until all ranks are
/// at the same place of a step, and becomes the host's then (fix_stop_request.h).
struct StopRequest {
  static constexpr int stop = 1, save = 2;
};

/// From now on Ctrl-C, SIGTERM, a closed terminal and SIGUSR2, which mpirun passes on, ask to stop
/// at a step, with a restart file; SIGUSR1 asks for the file alone. A second signal to stop ends
/// the program at once.
void install_stop_handlers();

/// What has been asked for since this rank's last call: a sum of the numbers above.
int take_request();
}  // namespace encased_column
