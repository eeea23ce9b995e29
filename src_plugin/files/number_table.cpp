// SPDX-License-Identifier: GPL-2.0-only
#include "files/number_table.h"

#include "core/input_error.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace encased_column {

namespace {

std::string trimmed(const std::string& text)
{
  const char blanks[] = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::vector<std::vector<double>> read_number_table(const std::string& keyword,
                                                   const std::string& path,
                                                   const std::string& header)
{
  std::ifstream in(path);
  std::stringstream text;
  // A folder opens like a file and fails only here.
  if (!in || !(text << in.rdbuf()))
    throw InputError("'" + keyword + "' must name a CSV file that can be read, found '" + path +
                     "', write its name with its folder");
  const auto columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',') + 1);
  std::vector<std::vector<double>> rows;
  bool has_header = false;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const std::string place = path + ":" + std::to_string(number);
    if (!has_header) {
      if (line != header)
        throw InputError("'" + keyword + "' " + place + " must start with the line '" + header +
                         "', found '" + line + "', write it above the rows");
      has_header = true;
      continue;
    }
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(read_number(keyword + " " + place, trimmed(cell)));
    if (row.size() != columns)
      throw InputError("'" + keyword + "' " + place + " must have " + std::to_string(columns) +
                       " values, found " + std::to_string(row.size()) + ", write '" + header + "'");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace encased_column
