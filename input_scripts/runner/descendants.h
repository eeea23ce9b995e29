#pragma once

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace encased_column {

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

/// Those of `processes` that run `program`: of a case its ranks, without mpirun and the helper
/// daemon that Open MPI gives a program started alone, for which our signals are not meant.
std::vector<Process> running(const std::vector<Process>& processes,
                             const std::filesystem::path& program);

}  // namespace encased_column
