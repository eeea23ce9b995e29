#pragma once

#include "runner/case_record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// One row of series.csv or of a user's own file: one test.
struct Case {
  std::string id;
  std::string deck;  ///< name of one of our decks, or the path of another
  bool by_default = false;
  Settings variables;
  std::string title, reproduces;
};

/// The rows of `file`, which `name` calls in messages. The columns id, deck and variables must be
/// there, default, title and reproduces may. Throws InputError for a file that is not such a table.
std::vector<Case> read_series(const std::filesystem::path& file, const std::string& name);

/// `ours` and behind them `theirs`; throws InputError for an id that both have.
std::vector<Case> together(const std::vector<Case>& ours, const std::vector<Case>& theirs);

}  // namespace encased_column
