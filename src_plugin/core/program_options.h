// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// A word that `liggghts-encase` takes besides those of LIGGGHTS.
struct ProgramOption {
  const char* name;
  const char* meaning;
};

constexpr ProgramOption program_options[] = {
    {"-help", "the options of LIGGGHTS and all styles, ours first"},
    {"-styles", "prints the styles of the plugin with their keywords and the tables they write"},
    {"-version", "prints what the program was built for and with, and the MPI that it finds"},
};

}  // namespace encased_column
