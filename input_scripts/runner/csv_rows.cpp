#include "runner/csv_rows.h"

#include "core/input_error.h"

#include <sstream>

namespace encased_column {

namespace {

std::string without_blanks(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The cell that begins at `place`, which goes to the comma behind it or to the end.
std::string take_cell(const std::string& line, std::size_t& place, const std::string& where)
{
  const std::size_t begin = line.find_first_not_of(" \t", place);
  if (begin == std::string::npos || line[begin] != '"') {
    const std::size_t comma = std::min(line.find(',', place), line.size());
    const std::string cell = without_blanks(line.substr(place, comma - place));
    if (cell.find('"') != std::string::npos)
      throw InputError(where + " must have quotes around whole cells only, found '" + cell +
                       "', write \"...\" from comma to comma");
    place = comma;
    return cell;
  }
  std::string cell;
  for (place = begin + 1; place < line.size(); ++place) {
    if (line[place] != '"')
      cell += line[place];
    else if (place + 1 < line.size() && line[place + 1] == '"')
      cell += line[place++];
    else
      break;
  }
  if (place >= line.size())
    throw InputError(where + " must close its quotes, found '\"" + cell +
                     "' without the second one, write \"...\"");
  place = std::min(line.find_first_not_of(" \t", place + 1), line.size());
  if (place < line.size() && line[place] != ',')
    throw InputError(where + " must have a comma behind quotes, found '" + line.substr(place) +
                     "', write \"...\",");
  return cell;
}

}  // namespace

std::vector<std::vector<std::string>> csv_rows(const std::string& text, const std::string& name)
{
  constexpr std::size_t longest = 10'000;
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::string where = "line " + std::to_string(number) + " of '" + name + "'";
    if (line.size() > longest)
      throw InputError(where + " must have " + std::to_string(longest) + " bytes at most, found " +
                       std::to_string(line.size()) + ", give the right file");
    if (without_blanks(line).empty() || line.front() == '#') continue;
    std::vector<std::string>& row = rows.emplace_back();
    std::size_t place = 0;
    row.push_back(take_cell(line, place, where));
    while (place < line.size()) row.push_back(take_cell(line, ++place, where));
    if (row.size() != rows.front().size())
      throw InputError(where + " must have " + std::to_string(rows.front().size()) +
                       " cells as the first one, found " + std::to_string(row.size()) +
                       ", write one for each column");
  }
  return rows;
}

std::string csv_cell(const std::string& cell)
{
  if (cell.find_first_of(",\"# ") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace encased_column
