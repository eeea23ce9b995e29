// SPDX-License-Identifier: GPL-2.0-only
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
  std::vector<std::string> series{};  ///< those it belongs to
};

/// The word of --series for all rows.
inline const char* const every_series = "all";

/// The rows of `file`, which `name` calls in messages. The columns id, deck and variables must be
/// there, series, default, title and reproduces may. Throws InputError for a file that is not such
/// a table.
std::vector<Case> read_series(const std::filesystem::path& file, const std::string& name);

/// The names of the series, each once, in the order of the rows.
std::vector<std::string> series_names(const std::vector<Case>& cases);

/// The cases of one series, or of "all". Throws InputError for a name that no row has.
std::vector<Case> cases_of_series(const std::string& series, const std::vector<Case>& cases);

/// `ours` and behind them `theirs`; throws InputError for an id that both have.
std::vector<Case> together(const std::vector<Case>& ours, const std::vector<Case>& theirs);

}  // namespace encased_column
