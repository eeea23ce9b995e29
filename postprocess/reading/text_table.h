// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace encased_column {

/// A CSV file as words, its columns found by their heading. Lines that start with # are comments.
class TextTable {
 public:
  TextTable() = default;

  /// Throws InputError if the file cannot be read or holds no row. A last row that was cut off,
  /// as that of a run still going on, is left out.
  explicit TextTable(const std::filesystem::path& file);

  std::size_t rows() const { return rows_; }
  bool has(const std::string& column) const;
  std::vector<std::string> headings() const;

  /// The words below the heading `column`; throws InputError if there is none.
  const std::vector<std::string>& words(const std::string& column) const;

  /// The same as finite numbers; throws InputError naming the first word that is none.
  std::vector<double> numbers(const std::string& column) const;

 private:
  std::filesystem::path file_;
  std::size_t rows_ = 0;
  std::map<std::string, std::vector<std::string>> columns_;
};

}  // namespace encased_column
