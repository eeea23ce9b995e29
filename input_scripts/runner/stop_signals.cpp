// SPDX-License-Identifier: GPL-2.0-only
#include "runner/stop_signals.h"

#include <cmath>
#include <initializer_list>

namespace encased_column {

StopSignals::StopSignals()
{
  sigemptyset(&awaited_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGCHLD}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (signal != SIGHUP || before.sa_handler != SIG_IGN) sigaddset(&awaited_, signal);
  }
  sigprocmask(SIG_BLOCK, &awaited_, nullptr);
  // A screen that is gone must not end us before the cases are told.
  std::signal(SIGPIPE, SIG_IGN);
}

int StopSignals::wait(double seconds)
{
  const double whole = std::floor(seconds);
  const timespec most{static_cast<time_t>(whole), static_cast<long>(1e9 * (seconds - whole))};
  const int signal = sigtimedwait(&awaited_, nullptr, &most);
  if (signal <= 0 || signal == SIGCHLD) return 0;
  if (count_++ == 0) first_ = signal;
  return signal;
}

}  // namespace encased_column
