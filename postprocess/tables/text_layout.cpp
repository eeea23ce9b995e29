// SPDX-License-Identifier: GPL-2.0-only
#include "tables/text_layout.h"

#include "core/input_error.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace encased_column {

std::string aligned(const Rows& rows, const std::vector<bool>& right)
{
  std::vector<std::size_t> widths(right.size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      const std::string space(widths[i] - rows[r][i].size(), ' ');
      line += (i > 0 ? "  " : "") + (right[i] ? space + rows[r][i] : rows[r][i] + space);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
    if (r > 0) continue;
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += (i > 0 ? "  " : "") + std::string(widths[i], '-');
    text += '\n';
  }
  return text;
}

std::string comma_separated(const Rows& rows)
{
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::string word = row[i];
      if (word.find_first_of(",\"\n") != std::string::npos) {
        for (std::size_t at = 0; (at = word.find('"', at)) != std::string::npos; at += 2)
          word.insert(at, 1, '"');
        word = '"' + word + '"';
      }
      text += (i > 0 ? "," : "") + word;
    }
    text += '\n';
  }
  return text;
}

std::string fixed(double x, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, x);
  return text;
}

void write_text(const std::filesystem::path& file, const std::string& text)
{
  std::ofstream stream(file);
  stream << text;
  stream.close();
  if (!stream)
    throw InputError("results must go where they can be written, found '" + file.string() +
                     "' refused, write for example '--output results'");
}

}  // namespace encased_column
