// SPDX-License-Identifier: GPL-2.0-only
#include "pages/word_table.h"

#include <fstream>
#include <stdexcept>

namespace encased_column::testing {

namespace {

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \r");
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(" \r") - first + 1);
}

std::vector<std::string> csv_cells(const std::string& line)
{
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

/// Where each column begins, from the line of dashes under the headings.
std::vector<std::size_t> column_starts(const std::string& dashes)
{
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < dashes.size(); ++i)
    if (dashes[i] == '-' && (i == 0 || dashes[i - 1] == ' ')) starts.push_back(i);
  return starts;
}

std::vector<std::string> cells_at(const std::vector<std::size_t>& starts, const std::string& line)
{
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : line.size();
    cells.push_back(starts[i] < line.size() ? trimmed(line.substr(starts[i], end - starts[i]))
                                            : "");
  }
  return cells;
}

}  // namespace

std::size_t WordTable::column(const std::string& heading) const
{
  const bool second = heading.rfind("2nd ", 0) == 0;
  const std::string name = second ? heading.substr(4) : heading;
  for (std::size_t i = 0, seen = 0; i < headings.size(); ++i)
    if (headings[i] == name && seen++ == (second ? 1 : 0)) return i;
  throw std::runtime_error("no column '" + heading + "'");
}

WordTable read_csv(const std::filesystem::path& file)
{
  WordTable table;
  for (const std::string& line : lines_of(file)) {
    if (line.empty() || line.front() == '#') continue;
    if (table.headings.empty()) {
      table.headings = csv_cells(line);
      continue;
    }
    table.rows.push_back(csv_cells(line));
    if (table.rows.back().size() != table.headings.size())
      throw std::runtime_error("a row of " + file.string() + " has " +
                               std::to_string(table.rows.back().size()) + " cells, not " +
                               std::to_string(table.headings.size()) + ": " + line);
  }
  return table;
}

std::vector<WordTable> read_printed_tables(const std::filesystem::path& file)
{
  std::vector<WordTable> tables;
  std::vector<std::size_t> starts;  // empty outside of a table
  std::string before;
  for (const std::string& line : lines_of(file)) {
    if (line.rfind("--", 0) == 0 && line.find_first_not_of("- ") == std::string::npos) {
      starts = column_starts(line);
      tables.push_back({cells_at(starts, before), {}});
    } else if (line.empty()) {
      starts.clear();
    } else if (!starts.empty()) {
      tables.back().rows.push_back(cells_at(starts, line));
    }
    before = line;
  }
  return tables;
}

std::vector<std::string> lines_of(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace encased_column::testing
