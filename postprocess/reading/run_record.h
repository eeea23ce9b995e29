// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// What a run folder says about how its run went, beside the results.
struct RunRecord {
  std::vector<std::string> warnings;    ///< of its logs, each once
  std::optional<std::string> finished;  ///< when, in UTC
  std::optional<long> wall_time;        ///< since the last start [s]
  double loop_time = 0.0;               ///< of the growth and shear loops, as the logs say [s]
  std::vector<std::string> versions;    ///< of this project, the machine and the packages
  std::vector<std::string> commands;    ///< one for each start
};

/// Reads the logs, finished, versions.txt and command.txt of `folder`; what is not there is left
/// out.
RunRecord read_run_record(const std::filesystem::path& folder);

}  // namespace encased_column
