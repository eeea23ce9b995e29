// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/passing_folder.h"
#include "runner/processes.h"

#include <sys/types.h>

#include <chrono>
#include <set>
#include <string>

namespace encased_column {

/// A lock on the folder of a case, held by its running process too: a case that outlives `encase`
/// is not started a second time.
class FolderLock {
 public:
  FolderLock() = default;
  FolderLock(FolderLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&& other) noexcept;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// False if another holds it for longer than `seconds`.
  bool take(const std::filesystem::path& file, double seconds);
  int file() const { return file_; }
  void note(pid_t pid) const;  ///< writes who holds it into the file

 private:
  int file_ = -1;
};

/// A case that runs.
class CaseProcess {
 public:
  /// Starts it; throws InputError when that is impossible.
  CaseProcess(const CaseFolder& folder, const std::vector<std::string>& command,
              const std::filesystem::path& host, FolderLock lock);

  const CaseFolder& folder() const { return *folder_; }
  /// True once it has ended; `code` as of a shell.
  bool has_ended(int& code) const;
  long seconds() const;

  /// Asks each rank to stop, once: called again it finds those that have come since.
  void ask_to_stop();
  /// Ends all its processes at once.
  void kill() const;
  /// Looks whether the run has said which variables it uses; see CaseFolder.
  void confirm_variables();
  bool is_confirmed() const { return confirmed_; }

 private:
  const CaseFolder* folder_;
  std::filesystem::path host_;
  FolderLock lock_;
  PassingFolder open_mpi_{"Open MPI works"};
  pid_t pid_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::set<Process> asked_;
  bool confirmed_ = false;
};

/// The number of a process that runs `host` in `folder`, 0 if there is none.
pid_t process_in(const std::filesystem::path& folder, const std::filesystem::path& host);

}  // namespace encased_column
