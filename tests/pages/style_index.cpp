// SPDX-License-Identifier: GPL-2.0-only
#include "pages/style_index.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

const std::string opening =
    "# Styles\n\n"
    "All fixes and commands that `liggghts-encase` adds to LIGGGHTS, made from the style table and "
    "the pages:\n"
    "`ENCASE_WRITE_INDEX=1 ./tests/run -R index_of_styles` writes this page again. "
    "`build/bin/liggghts-encase -styles` prints the\n"
    "keywords with their meanings. How they work together: "
    "[tutorials](../input_scripts/tutorials/README.md).\n\n"
    "| style | does | keywords | writes |\n"
    "|---|---|---|---|\n";

/// First words of a page: its title and the paragraph under it.
struct Head {
  std::string title, paragraph;
};

Head head_of(const fs::path& page)
{
  Head head;
  std::ifstream stream(page);
  for (std::string line; std::getline(stream, line);) {
    if (head.title.empty()) {
      if (line.rfind("# ", 0) == 0) head.title = line.substr(2);
    } else if (!line.empty()) {
      head.paragraph += (head.paragraph.empty() ? "" : " ") + line;
    } else if (!head.paragraph.empty()) {
      return head;
    }
  }
  throw std::runtime_error("no title with a paragraph in " + page.string());
}

std::string in_code(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "`" : ", `") + word + "`";
  return text;
}

/// Styles of the table that take the host's words.
std::vector<std::string> made_instead(const std::string& table)
{
  static const std::regex row(R"re(\{"([^"]+)", make_instead<)re");
  std::vector<std::string> names;
  for (std::sregex_iterator match(table.begin(), table.end(), row), none; match != none; ++match)
    names.push_back((*match)[1]);
  return names;
}

}  // namespace

std::vector<ListedStyle> listed_styles(const std::vector<std::string>& lines)
{
  const std::string command = "command ", table = "table ", row = "| `";
  std::vector<ListedStyle> styles;
  bool of_file = false;
  for (const std::string& line : lines) {
    if (line.rfind(row, 0) == 0) {
      if (!of_file) styles.back().keywords.push_back(line.substr(3, line.find('`', 3) - 3));
    } else if (line.rfind(table, 0) == 0) {
      of_file = true;
      styles.back().files.push_back(line.substr(table.size()));
    } else if (!line.empty()) {
      of_file = false;
      styles.push_back({line.rfind(command, 0) == 0 ? line.substr(command.size()) : line, {}, {}});
    }
  }
  return styles;
}

std::string style_index(const std::vector<ListedStyle>& styles, const std::vector<fs::path>& pages,
                        const std::string& table)
{
  std::string index = opening;
  std::size_t found = 0;
  for (const fs::path& page : pages) {
    const Head head = head_of(page);
    const auto style = std::find_if(styles.begin(), styles.end(), [&](const ListedStyle& one) {
      return one.title == head.title;
    });
    const bool of_host = head.title.rfind("pair_style ", 0) == 0;
    if (style == styles.end() && !of_host) continue;
    const ListedStyle listed = of_host ? ListedStyle{head.title, {}, {}} : *style;
    found += !of_host;
    index += "| [`" + head.title + "`](" + page.parent_path().filename().string() + "/" +
             page.filename().string() + ") | " + head.paragraph + " | " + in_code(listed.keywords) +
             " | " + in_code(listed.files) + " |\n";
  }
  if (found != styles.size()) throw std::runtime_error("a style of the program has no page");
  return index + "\nThe style table also makes " + in_code(made_instead(table)) +
         ": fixes of the host with the words of the host, which see the sleeve\nand the weight of "
         "grains with scaled masses, and what hears signals; no deck need know.\n";
}

}  // namespace encased_column::testing
