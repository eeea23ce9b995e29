// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// An example of a page: a deck that continues an opening deck, and what it must print.
struct Example {
  int line = 0;            ///< where it starts on the page
  bool must_fail = false;  ///< a `liggghts-error` block
  std::string opening;     ///< name after `after=`; empty: the block is a whole deck
  std::string deck;
  std::vector<std::string> output;  ///< lines of the `output` block that follows
};

/// What the tests read of a user page.
struct UserPage {
  std::string title;
  /// Keyword tables, a row as "`name` | values | unit | meaning".
  std::vector<std::string> keywords;
  /// Tables of columns, one after the other, a row as "`name` | unit | meaning".
  std::vector<std::string> columns;
  std::vector<Example> examples;
};

/// Throws std::runtime_error, with the line, for a page without title, a block that does not end,
/// an `output` block that belongs to no example and an example of which no output is given.
UserPage read_page(const std::filesystem::path& file);

/// The cells of a row of a Markdown table, without the blanks that align them, joined by " | ".
std::string table_row(const std::string& line);

}  // namespace encased_column::testing
