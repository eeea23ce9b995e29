#pragma once

#include "runner/places.h"
#include "runner/run_options.h"

namespace encased_column {

/// `encase run`: the exit code. Throws InputError before anything is begun.
int run_command(const Places& places, const RunOptions& options);

/// `encase list`.
int list_command(const Places& places, const RunOptions& options);

}  // namespace encased_column
