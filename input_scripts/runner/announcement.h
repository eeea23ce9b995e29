// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/dry_run.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// Where results go and what else is said before cases run.
struct Surroundings {
  std::string folder;       ///< of the results, as a user types it
  double free_bytes = 0.0;  ///< on its disk
  bool pictures = true;     ///< they are drawn at the end
};

/// What is about to run, how long it takes here and what it leaves, in three lines. `rate` as of
/// dry_run_table; nothing where it was not measured.
std::string announcement(const std::vector<ExpectedCase>& cases, const Schedule& schedule,
                         std::optional<double> rate, const Surroundings& around);

/// Whether `cases` take long enough for the speed of this machine to be measured first: more than a
/// minute on one that takes a million steps of a grain in a second and rank.
bool takes_minutes(const std::vector<ExpectedCase>& cases, const Schedule& schedule);

}  // namespace encased_column
