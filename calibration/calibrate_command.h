// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

#include <filesystem>
#include <ostream>

namespace encased_column {

/// What a user asks of `encase calibrate`.
struct CalibrateOptions {
  std::filesystem::path config, out;
  bool resume = false, report = false, retry = false, slurm = false;
};

/// Runs, goes on with, or reports on a calibration; tells how it goes on `out`. Returns the exit
/// code: 0 when it is done or its runs are submitted, 130 when a signal has stopped it.
int calibrate(const CalibrateOptions& options, const Places& places, std::ostream& out);

}  // namespace encased_column
