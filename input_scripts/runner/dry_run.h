// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/case_size.h"
#include "runner/places.h"
#include "runner/run_options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// A case that would run.
struct ExpectedCase {
  std::string id;
  std::optional<CaseSize> size;  ///< nothing where the deck does not tell it
  double done = 0.0;             ///< share that an earlier start has done
  std::string note;
};

/// What would run, longest first, with grains, steps, time and disk. `rate` are seconds for a
/// grain's step on one rank, `free_bytes` what the disk has left.
std::string dry_run_table(const std::vector<ExpectedCase>& cases, const Schedule& schedule,
                          double rate, double free_bytes);

/// "3 993", "45 MB".
std::string in_thousands(double number);
std::string in_bytes(double bytes);

/// What the disk has left where `folder` is or would be made.
double free_bytes_of(std::filesystem::path folder);

/// `encase run --dry-run`: looks, measures the machine, and prints that table.
int dry_run(const Places& places, const std::vector<CasePlan>& plans, const RunOptions& options,
            const std::filesystem::path& series, int cores);

}  // namespace encased_column
