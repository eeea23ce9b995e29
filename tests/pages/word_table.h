// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A table of words under a line of headings; rows have as many cells as there are headings.
struct WordTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  /// Number of the column under `heading`; "2nd NAME" is the second of two that have the same
  /// heading. Throws std::runtime_error when there is none.
  std::size_t column(const std::string& heading) const;
};

/// A CSV file: cells may stand in quotes, lines that begin with '#' are comments. Throws
/// std::runtime_error when the file cannot be read or a row has another number of cells.
WordTable read_csv(const std::filesystem::path& file);

/// The tables of a text file as `encase report` prints them: headings, a line of dashes as wide as
/// the columns, rows up to an empty line. A note below the last row counts as a row.
std::vector<WordTable> read_printed_tables(const std::filesystem::path& file);

/// The lines of a text file; throws std::runtime_error when it cannot be read.
std::vector<std::string> lines_of(const std::filesystem::path& file);

}  // namespace encased_column::testing
