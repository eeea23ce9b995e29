#pragma once

#include <filesystem>

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

}  // namespace encased_column
