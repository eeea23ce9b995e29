// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

#include <optional>
#include <string>

namespace encased_column {

/// What the log of a run says of its last `run`: "Loop time of 0.42 on 1 procs for 500 steps with
/// 3993 atoms". Seconds for a grain's step; nothing where no line is such.
std::optional<double> seconds_per_grain_step(const std::string& log);

/// The same of this machine while `at_once` programs run, measured in some seconds with the deck
/// speed/packing.lmp. Throws InputError where that does not run.
double measure_machine(const Places& places, int at_once);

}  // namespace encased_column
