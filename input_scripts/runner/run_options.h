#pragma once

#include "runner/setting.h"

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

}  // namespace encased_column
