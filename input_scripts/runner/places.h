// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// Where the programs, decks and tables lie: found from the program that runs, so that a build or
/// an installation may be moved.
struct Places {
  std::filesystem::path program;  ///< `encase` itself
  std::filesystem::path host;     ///< `liggghts-encase`
  std::filesystem::path inputs;   ///< series.csv, common/ and a folder for each deck
  std::filesystem::path source;   ///< the tree whose ./input_scripts/run called us; empty without
};

/// Throws InputError when the decks are nowhere.
Places find_places();

/// "encased columns 0.1", the machine, and the packages in it: one a line.
std::string versions_text(const std::string& of_project, int cores, int ranks,
                          const std::string& packages_file);

}  // namespace encased_column
