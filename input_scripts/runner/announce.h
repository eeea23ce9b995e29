#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// What is left where a signal has ended the whole.
struct Left {
  std::vector<std::pair<std::string, int>> resumable;  ///< case and the stage it goes on from
  std::vector<std::string> begin_again;                ///< cases without a restart file
  bool tables_missing = false;  ///< all cases have ended, their tables are not made
};

/// The last line after a signal: what --resume goes on with, and nothing else.
std::string stopped_line(const Left& left);

/// "encased columns 0.1", the machine, and the packages in it: one a line.
std::string versions_text(const std::string& of_project, int cores, int ranks,
                          const std::string& packages_file);

}  // namespace encased_column
