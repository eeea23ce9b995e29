// SPDX-License-Identifier: GPL-2.0-only
#include "runner/text_file.h"

#include "core/input_error.h"
#include "files/atomic_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// Bytes of the character that begins with `first`; 0 for a byte that begins none.
int length_of_character(unsigned char first)
{
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  if (first >= 0xf0 && first < 0xf5) return 4;
  return 0;
}

/// Text in UTF-8 without control characters but tabs and ends of lines.
bool is_text(const std::string& text)
{
  for (std::size_t n = 0; n < text.size();) {
    const auto first = static_cast<unsigned char>(text[n]);
    if ((first < 0x20 && first != '\t' && first != '\n' && first != '\r') || first == 0x7f)
      return false;
    const int length = length_of_character(first);
    if (length == 0 || n + static_cast<std::size_t>(length) > text.size()) return false;
    for (int k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[n + static_cast<std::size_t>(k)]) & 0xc0) != 0x80)
        return false;
    n += static_cast<std::size_t>(length);
  }
  return true;
}

}  // namespace

std::string read_text_file(const fs::path& file, const std::string& what, std::size_t most)
{
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  if (stream && !fs::is_directory(file)) {
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(file, failure);
    text.resize(failure ? 0 : static_cast<std::size_t>(std::min<std::uintmax_t>(size, most + 1)));
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || fs::is_directory(file) || stream.bad())
    throw InputError(what + " must be a file that can be read, found '" + shown(file) +
                     "', check the path");
  if (text.size() > most)
    throw InputError(what + " must have " + std::to_string(most) +
                     " bytes at most, found more in '" + shown(file) + "', give the right file");
  if (!is_text(text))
    throw InputError(what + " must be text in UTF-8, found other bytes in '" + shown(file) +
                     "', save it as plain text");
  return text;
}

void write_text_file(const fs::path& file, const std::string& text)
{
  if (!write_whole_file(file, text))
    throw InputError("'" + shown(file) +
                     "' must be a file that can be written, found that it cannot, free some space "
                     "or mend the folder's rights");
}

void append_to_file(const fs::path& file, const std::string& text)
{
  std::ofstream stream(file, std::ios::app);
  stream << text;
}

std::string shown(const fs::path& path)
{
  std::error_code failure;
  const fs::path here = fs::current_path(failure), whole = fs::absolute(path, failure);
  const fs::path way = whole.lexically_relative(here);
  if (here == "/" || way.empty() || *way.begin() == "..") return whole.lexically_normal().string();
  return way.string();
}

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
