// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"
#include "runner/run_options.h"

namespace encased_column {

/// `encase run`: the exit code. Throws InputError before anything is begun.
int run_command(const Places& places, const RunOptions& options);

/// Where the results of `encase run` go.
std::filesystem::path output_folder(const Places& places, const RunOptions& options);

/// The settings of Open MPI that our runs need, for all programs started from now on; `crowded`
/// where there are more ranks than cores.
void set_up_open_mpi(bool crowded);

/// `encase list`.
int list_command(const Places& places, const RunOptions& options);

}  // namespace encased_column
