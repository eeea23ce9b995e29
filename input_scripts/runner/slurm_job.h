// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// The cases of a command as jobs of Slurm.
struct SlurmJob {
  std::string name;
  std::filesystem::path folder;      ///< of the results, whole
  std::vector<std::string> ids;      ///< of the cases that are missing, the longest first
  std::vector<std::string> command;  ///< runs a case with `--case ID` behind it
  std::vector<std::string> report;   ///< makes tables and report
  std::string source;                ///< ENCASE_SOURCE; empty: none
  int ranks = 1;                     ///< of MPI, each case
  int jobs = 0;                      ///< tasks at once; 0: as many as Slurm gives
  std::vector<std::string> options;  ///< of the site, as --slurm-option has them
};

/// `word` as a shell reads it back.
std::string in_shell(const std::string& word);

/// The line of a job script for an option of sbatch, "partition=long" or "--partition=long". Throws
/// InputError for what is none and for those the jobs need for themselves.
std::string sbatch_line(const std::string& option);

/// The script of a job array with a task for each case, which runs where the user was: paths of
/// variables may be relative. A task goes on from its case's restart
/// file; asked to stop before its time ends (SIGUSR1) it writes one and puts itself in the queue
/// again.
std::string cases_script(const SlurmJob& job);

/// The script of the job that makes the report behind them.
std::string report_script(const SlurmJob& job);

}  // namespace encased_column
