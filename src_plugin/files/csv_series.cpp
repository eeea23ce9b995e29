// SPDX-License-Identifier: GPL-2.0-only
#include "files/csv_series.h"

#include "files/atomic_file.h"

#include <cstdlib>
#include <fstream>

namespace encased_column {

bool CsvSeries::go_back_to(double step)
{
  std::ifstream file(path_);
  std::string kept, line;
  while (std::getline(file, line))
    if (kept.empty() || std::strtod(line.c_str(), nullptr) <= step) kept += line + "\n";
  fresh_ = kept.empty();
  return fresh_ || write_whole_file(path_, kept);
}

bool CsvSeries::append(const std::vector<double>& numbers)
{
  std::ofstream file(path_, fresh_ ? std::ios::trunc : std::ios::app);
  const std::size_t count = columns_.size();
  if (fresh_)
    for (std::size_t n = 0; n < count; ++n) file << columns_[n] << (n + 1 < count ? "," : "\n");
  fresh_ = false;
  file.precision(9);
  for (std::size_t n = 0; n < numbers.size(); ++n)
    file << numbers[n] << ((n + 1) % count ? "," : "\n");
  return static_cast<bool>(file.flush());
}

}  // namespace encased_column
