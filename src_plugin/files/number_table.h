// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Numbers of a CSV file row by row, under a first line `header` of names and units; empty lines
/// and lines that start with # are skipped. Throws InputError naming `keyword`, the file and the
/// line.
std::vector<std::vector<double>> read_number_table(const std::string& keyword,
                                                   const std::string& path,
                                                   const std::string& header);

}  // namespace encased_column
