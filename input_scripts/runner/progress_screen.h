// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace encased_column {

/// Lines about how far things are: on a terminal written over and over each second, else below one
/// another every half minute.
class ProgressScreen {
 public:
  ProgressScreen();

  /// True where it is time for other lines.
  bool is_due() const;
  void show(const std::vector<std::string>& lines);
  /// Makes room for a line that stays.
  void clear();

 private:
  bool on_terminal_;
  std::size_t shown_ = 0;  ///< lines that stand on the terminal
  std::chrono::steady_clock::time_point spoken_;
};

}  // namespace encased_column
