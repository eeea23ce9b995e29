#pragma once

#include "runner/case_record.h"

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
  std::filesystem::path cases_file, deck, out;
  std::string resolution;  ///< empty: the deck's own
  std::vector<std::string> set;
  std::string name;  ///< empty: default
  bool keep = false, resume = false, no_pictures = false;
  std::string ranks, jobs;

  Settings settings() const;
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

/// What finishes `cases` soonest on `cores`; `ranks` and `jobs` hold what is given, 0 what is free.
///
/// Cases side by side are perfectly parallel but leave cores idle in the last round; 1, 2, 3 and 4
/// ranks run a case 1, 1.85, 2.6 and 3.3 times as fast (measured at `paper`).
Schedule best_schedule(int cases, int cores, int ranks = 0, int jobs = 0);

}  // namespace encased_column
