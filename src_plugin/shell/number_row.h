// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace encased_column {

/// Numbers of a restart file, taken one after the other.
class NumberRow {
 public:
  explicit NumberRow(const std::vector<double>& numbers) : numbers_(numbers) {}

  /// Throws InputError where none is left.
  void take(double* to, std::size_t count)
  {
    if (next_ + count > numbers_.size())
      throw InputError("the sleeve of the restart file must be whole, found " +
                       std::to_string(numbers_.size()) + " numbers, go on from another file");
    std::copy_n(numbers_.begin() + static_cast<long>(next_), count, to);
    next_ += count;
  }
  double take()
  {
    double number;
    take(&number, 1);
    return number;
  }

 private:
  const std::vector<double>& numbers_;
  std::size_t next_ = 0;
};

}  // namespace encased_column
