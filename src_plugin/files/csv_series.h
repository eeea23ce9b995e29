// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// A CSV file that grows during a run, of which the first column is the step. A run that goes back
/// to a restart file drops the rows behind it and writes them again.
class CsvSeries {
 public:
  CsvSeries(std::string path, std::vector<std::string> columns)
      : path_(std::move(path)),
        columns_(std::move(columns))
  {
  }
  const std::string& path() const { return path_; }

  /// The next row starts a new file.
  void start_anew() { fresh_ = true; }
  /// Keeps the rows up to `step`; false when the file cannot be written.
  bool go_back_to(double step);
  /// Writes a row of one or several records of as many numbers as there are columns; false when
  /// that is impossible.
  bool append(const std::vector<double>& numbers);

 private:
  std::string path_;
  std::vector<std::string> columns_;
  bool fresh_ = true;
};

}  // namespace encased_column
