// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace encased_column {

/// How far one case of several has come, and what that took.
struct CaseClock {
  double work = 1.0;      ///< of the whole case, in a unit common to all
  double brought = 0.0;   ///< share of it that was done before it was started
  double fraction = 0.0;  ///< share of it that is done now
  double seconds = 0.0;   ///< it has run since its start
  bool begun = false, ended = false;
};

/// Time [s] until the last of `clocks` ends where `jobs` run at once and the others follow in their
/// order, each as soon as one has ended. A unit of work takes as long as it took so far; nothing
/// where too little is done to say.
std::optional<double> seconds_left(const std::vector<CaseClock>& clocks, int jobs);

/// The places of `work` from the largest to the smallest; equal ones stay in their order.
std::vector<std::size_t> largest_first(const std::vector<double>& work);

/// Time [s] of all `work` before anything is begun, with `rate` seconds a unit of work.
double seconds_of_all(const std::vector<double>& work, double rate, int jobs);

}  // namespace encased_column
