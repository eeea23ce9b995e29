// SPDX-License-Identifier: GPL-2.0-only
#include "pages/markdown_links.h"

#include "pages/source_tree.h"

#include "pages/word_table.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

bool is_fence(const std::string& line)
{
  const auto first = line.find_first_not_of(' ');
  return first != std::string::npos && line.compare(first, 3, "```") == 0;
}

}  // namespace

std::vector<Link> local_links(const std::vector<std::string>& lines)
{
  static const std::regex code_span("`[^`]*`");
  static const std::regex link(R"re(\]\(([^)\s]+)[^)]*\)|(?:src|href)="([^"]*)")re");
  static const std::regex elsewhere("[a-z]+:.*");
  std::vector<Link> links;
  bool code = false;
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    if (is_fence(line)) code = !code;
    if (code || line.rfind("    ", 0) == 0) continue;
    const std::string text = std::regex_replace(line, code_span, "`");
    for (std::sregex_iterator match(text.begin(), text.end(), link), none; match != none; ++match) {
      const std::string target = (*match)[1].matched ? (*match)[1] : (*match)[2];
      if (!std::regex_match(target, elsewhere)) links.push_back({number, target});
    }
  }
  return links;
}

std::vector<std::string> heading_names(const std::vector<std::string>& lines)
{
  static const std::regex heading("#+ +(.*)");
  std::vector<std::string> names;
  bool code = false;
  for (const std::string& line : lines) {
    std::smatch match;
    if (is_fence(line)) code = !code;
    if (code || !std::regex_match(line, match, heading)) continue;
    std::string name;
    for (const unsigned char c : match[1].str()) {
      if (std::isalnum(c) || c == '-' || c == '_') name += char(std::tolower(c));
      if (c == ' ') name += '-';
    }
    names.push_back(name);
  }
  return names;
}

std::string problem_with(const std::string& target, const fs::path& page)
{
  const std::size_t hash = target.find('#');
  const std::string file = target.substr(0, hash);
  const fs::path there = file.empty() ? page : page.parent_path() / file;
  if (!fs::exists(there)) return "there is no '" + there.string() + "'";
  if (hash == std::string::npos) return "";
  const auto names = heading_names(lines_of(there));
  const std::string name = target.substr(hash + 1);
  return std::find(names.begin(), names.end(), name) != names.end()
             ? ""
             : "'" + there.string() + "' has no heading '" + name + "'";
}

std::vector<fs::path> pages_below(const fs::path& root)
{
  std::vector<fs::path> pages;
  for (const fs::path& file : files_of_tree(root))
    if (file.extension() == ".md") pages.push_back(file);
  return pages;
}

std::vector<std::string> broken_links(const fs::path& root)
{
  std::vector<std::string> broken;
  for (const fs::path& page : pages_below(root))
    for (const Link& link : local_links(lines_of(page))) {
      const std::string problem = problem_with(link.target, page);
      if (!problem.empty())
        broken.push_back(page.string() + ":" + std::to_string(link.line) + ": " + problem);
    }
  return broken;
}

}  // namespace encased_column::testing
