// SPDX-License-Identifier: GPL-2.0-only
// Every user page src_plugin/*/*.md tells the truth: its keywords are those of the program, its
// examples run and print what it says, on any number of ranks, and its mistakes are refused as it
// says.
#include "pages/style_index.h"
#include "pages/user_page.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <tuple>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> all_pages()
{
  std::vector<fs::path> pages;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ENCASE_SOURCE) / "src_plugin"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  std::sort(pages.begin(), pages.end());
  return pages;
}

/// What the program says of a style: the rows of its keyword table, and those of the tables it
/// writes, one after the other.
struct StyleTables {
  std::vector<std::string> keywords, columns;
};

/// By "fix NAME", or "NAME" of a command.
const std::map<std::string, StyleTables>& styles_of_the_program()
{
  static const auto styles = [] {
    std::map<std::string, StyleTables> found;
    std::string style;
    bool in_table = false;
    for (const std::string& line : run_program({ENCASE_PROGRAM, "-styles"}, "/").lines()) {
      const std::string command = "command ";
      if (line.rfind("|", 0) == 0) {
        StyleTables& tables = found[style];
        (in_table ? tables.columns : tables.keywords).push_back(table_row(line));
      } else if (line.rfind("table ", 0) == 0) {
        in_table = true;
      } else if (!line.empty()) {
        in_table = false;
        found[style = line.rfind(command, 0) == 0 ? line.substr(command.size()) : line];
      }
    }
    return found;
  }();
  return styles;
}

/// The first of `wanted` that `lines` does not hold, in order; empty when all are there.
std::string missing_line(const std::vector<std::string>& wanted,
                         const std::vector<std::string>& lines)
{
  auto from = lines.begin();
  for (const std::string& line : wanted) {
    from = std::find(from, lines.end(), line);
    if (from == lines.end()) return line;
    ++from;
  }
  return "";
}

std::string end_of(const std::string& output)
{
  return output.size() > 3000 ? "..." + output.substr(output.size() - 3000) : output;
}

void check_example(const Example& example, int ranks)
{
  const std::string opening = example.opening.empty() ? "" : opening_deck(example.opening);
  const Outcome outcome = run_deck(opening + example.deck, ranks);
  if (example.must_fail) {
    EXPECT_NE(outcome.exit_code, 0);
    for (const std::string& sentence : example.output)
      EXPECT_TRUE(outcome.says(sentence)) << sentence << "\nnot in\n" << end_of(outcome.output);
  } else {
    EXPECT_EQ(outcome.exit_code, 0) << end_of(outcome.output);
    EXPECT_EQ(missing_line(example.output, outcome.lines()), "") << "is not in its place in\n"
                                                                 << end_of(outcome.output);
  }
}

std::string name_of(const fs::path& page)
{
  std::string name = page.parent_path().filename().string() + "_" + page.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

/// Headings of the second rank and the text under each, in order.
std::vector<std::pair<std::string, std::string>> sections_of(const fs::path& page)
{
  std::vector<std::pair<std::string, std::string>> sections;
  std::ifstream stream(page);
  for (std::string line; std::getline(stream, line);)
    if (line.rfind("## ", 0) == 0)
      sections.emplace_back(line.substr(3), "");
    else if (!sections.empty())
      sections.back().second += line + "\n";
  return sections;
}

/// Whether it is the page of a style, and no theory or index.
bool is_of_style(const UserPage& page)
{
  return styles_of_the_program().count(page.title) || page.title.rfind("pair_style ", 0) == 0;
}

/// What a keyword's meaning calls its default: a word or a number, "" for one told in a sentence.
std::string default_in(const std::string& meaning)
{
  static const std::vector<std::regex> forms{
      std::regex(R"(.*\((?:[^()]*; )?default `?([^\s:,`)]+)`?(?:\)|:.*\)|,.*\)).*)"),
      std::regex(R"(.*`([^`]+)` \(default\).*)"), std::regex(R"((\w+) \(default[^)]*\).*)"),
      std::regex(R"(.*\((\S+) where not given\).*)")};
  std::smatch match;
  for (const std::regex& form : forms)
    if (std::regex_match(meaning, match, form)) return match[1];
  return "";
}

class Page : public ::testing::TestWithParam<fs::path> {};

/// A page and the number of ranks its examples run on.
class PageOnRanks : public ::testing::TestWithParam<std::tuple<fs::path, int>> {};

}  // namespace

TEST_P(Page, ListsTheKeywordsAndColumnsOfTheProgram)
{
  const UserPage page = read_page(GetParam());
  const auto style = styles_of_the_program().find(page.title);
  if (style != styles_of_the_program().end()) {
    EXPECT_EQ(page.keywords, style->second.keywords) << "on the page and in the program";
    EXPECT_EQ(page.columns, style->second.columns) << "on the page and in the program";
  } else {
    EXPECT_NE(page.title.rfind("fix ", 0), 0u) << "no such style in the program";
  }
}

TEST_P(PageOnRanks, HasExamplesThatRunAndMistakesThatAreRefused)
{
  const auto& [page, ranks] = GetParam();
  for (const Example& example : read_page(page).examples) {
    if (ranks == 4 && example.must_fail) continue;
    SCOPED_TRACE(page.string() + ":" + std::to_string(example.line) + " on " +
                 std::to_string(ranks) + " ranks");
    check_example(example, ranks);
  }
}

TEST_P(Page, HasTheSectionsThatReadersOfLammpsLookFor)
{
  if (!is_of_style(read_page(GetParam()))) GTEST_SKIP() << "no page of a style";
  std::vector<std::string> headings;
  for (const auto& [heading, text] : sections_of(GetParam())) {
    headings.push_back(heading);
    EXPECT_NE(text.find_first_not_of(" \n"), std::string::npos) << heading << " is empty";
    if (heading == "Related") {
      EXPECT_NE(text.find("](../STYLES.md)"), std::string::npos) << "a link to the index";
      EXPECT_NE(text.find(".md), "), std::string::npos) << "a link to another style";
    }
  }
  std::vector<std::string> wanted{
      "Syntax",  "Example", "Description", "Restart and output", "Accuracy and limits",
      "Related", "Default"};
  if (headings.size() > wanted.size()) wanted.push_back("References");
  EXPECT_EQ(headings, wanted);
}

TEST_P(Page, GivesTheDefaultOfEachKeyword)
{
  const UserPage page = read_page(GetParam());
  std::string given;
  for (const auto& [heading, text] : sections_of(GetParam()))
    if (heading == "Default") given = text;
  std::replace(given.begin(), given.end(), '\n', ' ');
  for (const std::string& row : page.keywords) {
    const std::string name = row.substr(1, row.find('`', 1) - 1),
                      meaning = row.substr(row.rfind(" | ") + 3), value = default_in(meaning);
    if (meaning.find("default") == std::string::npos && value.empty()) continue;
    EXPECT_NE(given.find('`' + name), std::string::npos) << name << ": " << meaning;
    // A default of several words is told by its first one.
    if (value.empty() || value == "still") continue;
    const bool is_given = given.find('`' + name + ' ' + value) != std::string::npos ||
                          given.find('`' + name + "` " + value) != std::string::npos;
    EXPECT_TRUE(is_given) << name << ' ' << value << " of: " << meaning;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Page, ::testing::ValuesIn(all_pages()),
                         [](const auto& page) { return name_of(page.param); });

INSTANTIATE_TEST_SUITE_P(Pages, PageOnRanks,
                         ::testing::Combine(::testing::ValuesIn(all_pages()),
                                            ::testing::Values(1, 2, 4)),
                         [](const auto& page) {
                           return name_of(std::get<0>(page.param)) + "_on_" +
                                  std::to_string(std::get<1>(page.param));
                         });

TEST(Pages, ThereIsOneForEveryStyle)
{
  std::vector<std::string> titles;
  for (const fs::path& page : all_pages()) titles.push_back(read_page(page).title);
  for (const auto& [style, tables] : styles_of_the_program())
    EXPECT_EQ(std::count(titles.begin(), titles.end(), style), 1)
        << "pages titled '# " << style << "'";
}

// The index is the style table and the pages, as they are now.
TEST(Pages, AreInTheIndexOfStyles)
{
  const fs::path folder = fs::path(ENCASE_SOURCE) / "src_plugin", file = folder / "STYLES.md";
  std::vector<fs::path> pages;
  for (const fs::path& page : all_pages())
    if (page.parent_path() != folder) pages.push_back(page);
  const std::string index =
      style_index(listed_styles(run_program({ENCASE_PROGRAM, "-styles"}, "/").lines()), pages,
                  read_text(folder / "style_table.cpp"));
  if (getenv("ENCASE_WRITE_INDEX")) std::ofstream(file) << index;
  EXPECT_EQ(read_text(file), index)
      << "write it again with ENCASE_WRITE_INDEX=1 ./tests/run -R index_of_styles";
}
