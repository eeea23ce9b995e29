// SPDX-License-Identifier: GPL-2.0-only
#include "support/csv_table.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace encased_column::testing {

namespace {

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const auto first = cell.find_first_not_of(" \r\"");
    const auto last = cell.find_last_not_of(" \r\"");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw std::runtime_error("no names in " + file.string());
  const std::vector<std::string> names = split(line);
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = split(line);
    if (cells.size() != names.size())
      throw std::runtime_error("row " + std::to_string(rows_ + 1) + " of " + file.string() +
                               " has " + std::to_string(cells.size()) + " values, not " +
                               std::to_string(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
      char* end = nullptr;
      columns_[names[i]].push_back(std::strtod(cells[i].c_str(), &end));
      if (cells[i].empty() || *end)
        throw std::runtime_error("'" + cells[i] + "' in " + file.string() + " is not a number");
    }
    ++rows_;
  }
}

}  // namespace encased_column::testing
