// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// Slurm with one node of two processors, this machine, from Debian's packages slurm-wlm and munge:
/// three programs that end with this object. Its commands find it by SLURM_CONF.
class OneNodeSlurm {
 public:
  /// Starts it with all its files in `folder`.
  explicit OneNodeSlurm(const std::filesystem::path& folder);
  ~OneNodeSlurm();
  OneNodeSlurm(const OneNodeSlurm&) = delete;
  OneNodeSlurm& operator=(const OneNodeSlurm&) = delete;

  /// Why it does not run; empty if it does.
  const std::string& missing() const { return missing_; }
  /// What a command of Slurm prints.
  Outcome ask(const std::vector<std::string>& words) const { return run_program(words, folder_); }

 private:
  void write_configuration() const;
  void start(const std::vector<std::string>& words);
  bool is_idle() const;

  std::filesystem::path folder_;
  std::vector<pid_t> programs_;
  std::string missing_;
};

}  // namespace encased_column::testing
