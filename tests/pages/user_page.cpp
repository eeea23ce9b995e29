// SPDX-License-Identifier: GPL-2.0-only
#include "pages/user_page.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace encased_column::testing {

namespace {

const std::string fence = "```";

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Reads a page line by line and keeps the place for messages.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file)
  {
    if (!stream_) refuse("cannot be read");
  }

  bool next(std::string& line)
  {
    ++number_;
    return static_cast<bool>(std::getline(stream_, line));
  }

  /// The lines up to the closing fence.
  std::vector<std::string> block()
  {
    std::vector<std::string> lines;
    for (std::string line; next(line);) {
      if (line == fence) return lines;
      lines.push_back(line);
    }
    refuse("a block does not end");
  }

  int number() const { return number_; }

  [[noreturn]] void refuse(const std::string& why) const
  {
    throw std::runtime_error(file_.string() + ":" + std::to_string(number_) + ": " + why);
  }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  int number_ = 0;
};

Example example_of(const std::string& head, Reader& reader)
{
  Example example;
  example.line = reader.number();
  example.must_fail = head.rfind("liggghts-error", 0) == 0;
  const auto after = head.find("after=");
  if (after != std::string::npos) example.opening = trimmed(head.substr(after + 6));
  for (const std::string& line : reader.block()) example.deck += line + "\n";
  return example;
}

void add_block(const std::string& head, Reader& reader, UserPage& page)
{
  std::vector<Example>& examples = page.examples;
  const bool unanswered = !examples.empty() && examples.back().output.empty();
  if (head.rfind("liggghts", 0) == 0) {
    if (unanswered) reader.refuse("the example before has no output block");
    examples.push_back(example_of(head, reader));
  } else if (head == "output") {
    if (!unanswered) reader.refuse("an output block without an example before it");
    for (const std::string& line : reader.block())
      if (!trimmed(line).empty()) examples.back().output.push_back(trimmed(line));
  } else {
    reader.block();
  }
}

}  // namespace

std::string table_row(const std::string& line)
{
  std::string row;
  std::istringstream cells(line.substr(line.find('|') + 1));
  for (std::string cell; std::getline(cells, cell, '|');)
    row += (row.empty() ? "" : " | ") + trimmed(cell);
  return row;
}

UserPage read_page(const std::filesystem::path& file)
{
  UserPage page;
  Reader reader(file);
  bool in_keywords = false, in_columns = false;
  for (std::string line; reader.next(line);) {
    if (page.title.empty() && line.rfind("# ", 0) == 0) page.title = trimmed(line.substr(2));
    if (line.rfind(fence, 0) == 0) add_block(trimmed(line.substr(fence.size())), reader, page);
    const bool in_table = line.rfind("|", 0) == 0;
    if (in_table && table_row(line) == "keyword | values | unit | meaning") in_keywords = true;
    if (in_keywords && line.rfind("| `", 0) == 0) page.keywords.push_back(table_row(line));
    if (in_table && table_row(line) == "column | unit | meaning") in_columns = true;
    if (in_columns && line.rfind("| `", 0) == 0) page.columns.push_back(table_row(line));
    in_keywords = in_keywords && in_table;
    in_columns = in_columns && in_table;
  }
  if (page.title.empty()) reader.refuse("no title line '# ...'");
  if (!page.examples.empty() && page.examples.back().output.empty())
    reader.refuse("the last example has no output block");
  return page;
}

}  // namespace encased_column::testing
