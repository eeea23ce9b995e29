// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// What one look at the machine found.
struct Finding {
  enum class Verdict { good, note, bad };
  std::string what;  ///< "MPI"
  Verdict verdict = Verdict::good;
  std::string sentence;  ///< what is there; where it is not enough, what to do
};

/// What a program answered, and how long it took.
struct Trial {
  int code = 127;  ///< 127: there is no such program
  std::string text;
  double seconds = 0.0;
};

/// `version`: what the program with the plugin says of itself, `file` where it should be.
Finding judge_programs(const Trial& version, const std::string& file);

/// `start`: of `ranks` ranks of that program under mpirun.
Finding judge_mpi(const Trial& start, int ranks);

/// `problem`: why pictures cannot be drawn; empty if they can.
Finding judge_display(const std::string& problem);

/// `free` and `needed` bytes on the disk of `folder`; `writable` if files can be made there.
Finding judge_disk(double free, double needed, const std::string& folder, bool writable);

/// `free` bytes of memory beside those `needed`.
Finding judge_memory(double free, double needed);

Finding judge_cores(int cores);

/// `ping`: of Slurm's controller by `scontrol ping`.
Finding judge_slurm(const Trial& ping);

/// One line each, and what to do next.
std::string doctor_text(const std::vector<Finding>& findings);

/// Memory [bytes] of a case with `grains` on one rank. Measured on Debian 12: 46 MB with 3 100
/// grains, 116 MB with 40 800.
double memory_of_case(double grains);

/// The value of MemAvailable in /proc/meminfo [bytes]; 0 where `text` has none.
double available_memory(const std::string& text);

}  // namespace encased_column
