// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_record.h"
#include "runner/resume_decision.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace encased_column {

/// What the user asks of `encase run`.
struct RunOptions {
  bool list = false;
  std::vector<std::string> cases;
  std::string series;  ///< empty: not given
  std::filesystem::path cases_file, deck, out;
  std::string resolution;  ///< empty: the deck's own
  std::vector<std::string> set;
  std::string name;  ///< empty: default
  bool keep = false, resume = false, retry = false, no_pictures = false;
  bool dry_run = false;
  bool no_report = false;    ///< only the cases: another command makes tables and report
  bool report_only = false;  ///< only tables and report
  bool slurm = false;
  std::vector<std::string> slurm_options;
  std::string ranks, jobs;

  Settings settings() const;
  /// What becomes of cases that were run before: a series runs what is missing, and so does Slurm.
  Wishes wishes() const
  {
    const bool missing = is_series() || slurm;
    return {keep, resume || missing, missing && !retry};
  }
  bool is_series() const { return !series.empty(); }
  int rank_count() const { return whole_number("--ranks", ranks); }  ///< 0: not given
  int job_count() const { return whole_number("--jobs", jobs); }
  /// Throws InputError for a value that is out of its rule.
  void check() const;

 private:
  static int whole_number(const std::string& option, const std::string& word);
};

void add_run_options(CLI::App& command, RunOptions& options);

/// How cases share a machine.
struct Schedule {
  int ranks = 1;  ///< of MPI, each case
  int jobs = 1;   ///< cases at once
};

/// How many times as fast as one a number of ranks runs a case: 1, 1.85, 2.6 and 3.3 (measured at
/// `paper`); more count as 4 at most.
double speed_of_ranks(int ranks);

/// What finishes `cases` soonest on `cores`; `ranks` and `jobs` hold what is given, 0 what is free.
///
/// Cases side by side are perfectly parallel but leave cores idle in the last round.
Schedule best_schedule(int cases, int cores, int ranks = 0, int jobs = 0);

}  // namespace encased_column
