// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace encased_column {

/// How a program is started beside this one.
struct Start {
  std::vector<std::string> words;
  std::filesystem::path folder;  ///< it runs in; empty: here
  std::filesystem::path screen;  ///< file its words are added to; empty: our own screen
  bool own_session =
      false;           ///< Ctrl-C of the terminal does not reach it; it takes SIGUSR2 if we go
  int kept_file = -1;  ///< a descriptor it inherits, besides its screen
  /// Where Open MPI keeps what it needs during the run: a folder of this program's own, as programs
  /// that share one remove it under each other. Empty: Open MPI's choice.
  std::filesystem::path open_mpi_folder;
};

/// Starts a program with no input; throws InputError when that is impossible. A program that cannot
/// be found ends with exit code 127.
pid_t start_program(const Start& start);

/// True once `pid` has ended; then `code` is its exit code, 128 + signal if one ended it.
bool has_ended(pid_t pid, int& code);

/// All that `words` write to their screen, errors left out; empty when they fail.
std::string output_of(const std::vector<std::string>& words);

/// How a program ended, and all it wrote to its screen, errors too.
struct Answer {
  int code = 127;
  std::string text;
};
Answer answer_of(const std::vector<std::string>& words);

/// A process, told from a later one with the same number by when it began.
struct Process {
  pid_t pid;
  unsigned long long began;  ///< ticks since the machine started
  bool operator<(const Process& other) const
  {
    return pid != other.pid ? pid < other.pid : began < other.began;
  }
};

/// `root` and all below it, as /proc tells.
std::vector<Process> process_tree(pid_t root);

/// Those of `processes` that run `program`: of a case its ranks, without mpirun, for which our
/// signals are not meant.
std::vector<Process> running(const std::vector<Process>& processes,
                             const std::filesystem::path& program);

}  // namespace encased_column
