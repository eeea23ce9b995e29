// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A file of comma-separated numbers under one line of names, read by name.
class CsvTable {
 public:
  /// Throws std::runtime_error when the file cannot be read, a row has another number of values
  /// than there are names, or a value is not a number.
  explicit CsvTable(const std::filesystem::path& file);

  /// The column under `name`, given as the file has it ("height [m]"); throws std::out_of_range.
  std::vector<double> column(const std::string& name) const { return columns_.at(name); }
  std::size_t rows() const { return rows_; }

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace encased_column::testing
