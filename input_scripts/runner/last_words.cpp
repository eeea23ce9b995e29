// SPDX-License-Identifier: GPL-2.0-only
#include "runner/last_words.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

std::string last_lines(const std::string& text, std::size_t most)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  std::string last;
  for (std::size_t n = lines.size() > most ? lines.size() - most : 0; n < lines.size(); ++n)
    last += lines[n] + "\n";
  return last;
}

/// The lines with ERROR and the two behind each.
std::string errors_in(const std::string& text)
{
  std::string errors;
  int open = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.find("ERROR") != std::string::npos) open = 3;
    if (open-- > 0) errors += line + "\n";
  }
  return errors;
}

}  // namespace

std::string end_of(const fs::path& file, std::streamoff most)
{
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(size - most, 0));
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string last_words_of(const fs::path& log, const fs::path& screen)
{
  for (const fs::path& file : {log, screen}) {
    const std::string errors = errors_in(end_of(file, 20'000));
    if (!errors.empty()) return last_lines(errors, 6);
  }
  return last_lines(end_of(screen, 20'000), 6);
}

}  // namespace encased_column
