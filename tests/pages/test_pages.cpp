// SPDX-License-Identifier: GPL-2.0-only
// Every user page src_plugin/*/*.md tells the truth: its keywords are those of the program, its
// examples run and print what it says, on any number of ranks, and its mistakes are refused as it
// says.
#include "pages/user_page.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
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
