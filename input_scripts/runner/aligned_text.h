// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace encased_column {

/// `rows` of as many cells each as lines whose columns stand below each other, two blanks apart;
/// those in `right` are flush right.
inline std::string aligned(const std::vector<std::vector<std::string>>& rows,
                           const std::vector<std::size_t>& right = {})
{
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t n = 0; n < row.size(); ++n) widths[n] = std::max(widths[n], row[n].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t n = 0; n < row.size(); ++n) {
      line.append(n && widths[n] ? 2 : 0, ' ');
      const std::string blanks(widths[n] - row[n].size(), ' ');
      const bool is_right = std::count(right.begin(), right.end(), n) > 0;
      line += is_right ? blanks + row[n] : row[n] + blanks;
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace encased_column
