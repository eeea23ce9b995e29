// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A folder with both decks and small.csv, whose cases `plain` and `encased` have about a hundred
/// grains and the parameters of the study, to 2 % strain: a second or two of work each. Restart
/// files come every 700 steps: not where the host sorts grains by itself.
void prepare_small_cases(const std::filesystem::path& folder);

/// `encase run` on those cases.
class RunningCommand {
 public:
  /// Starts it in `folder` with results in `out`; `options` behind those.
  RunningCommand(const std::filesystem::path& folder, const std::string& out,
                 const std::vector<std::string>& options);
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  /// Waits until `happened`; false when the command ends before, or after a minute.
  bool wait_until(const std::function<bool()>& happened);
  void send(int signal) const;
  /// Waits for its end.
  Outcome end();

 private:
  pid_t pid_;
  int code_ = -1;
  std::filesystem::path screen_;
  bool has_ended();
};

}  // namespace encased_column::testing
