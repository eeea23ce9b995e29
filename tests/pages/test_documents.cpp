// SPDX-License-Identifier: GPL-2.0-only
// Every page of the source tree can be followed, there and once installed: its links and pictures
// are there. The first page stays short and begins with what a newcomer needs.
#include "pages/markdown_links.h"
#include "pages/word_table.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;
const std::vector<std::string> none;

bool any_line_has(const std::vector<std::string>& lines, const std::string& words)
{
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

}  // namespace

TEST(Documents, HaveLinksThatLeadSomewhere)
{
  EXPECT_GT(pages_below(source).size(), 20u);
  EXPECT_EQ(broken_links(source), none);
}

// As `cmake --install` and the Debian package lay them.
TEST(Documents, HaveLinksThatLeadSomewhereOnceInstalled)
{
  const TemporaryFolder prefix;
  const Outcome outcome =
      run_program({"cmake", "--install", ENCASE_BUILD, "--prefix", prefix.path()}, prefix.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const fs::path installed = prefix.path() / "share/doc/encased-columns";
  EXPECT_EQ(pages_below(installed).size(), pages_below(source).size());
  EXPECT_EQ(broken_links(installed), none);
}

// From the first page, link by link.
TEST(Documents, AreAllReachedFromTheFirstPage)
{
  std::set<fs::path> reached;
  std::vector<fs::path> open{source / "README.md"};
  while (!open.empty()) {
    const fs::path page = open.back();
    open.pop_back();
    if (!reached.insert(page).second) continue;
    for (const Link& link : local_links(lines_of(page))) {
      const std::string file = link.target.substr(0, link.target.find('#'));
      fs::path there = (page.parent_path() / file).lexically_normal();
      if (there.extension() == ".md" && fs::exists(there)) open.push_back(there);
    }
  }
  for (const fs::path& page : pages_below(source))
    EXPECT_TRUE(reached.count(page)) << "no link leads to " << page.string();
}

TEST(Documents, BeginWithAShortPage)
{
  const std::vector<std::string> lines = lines_of(source / "README.md");
  EXPECT_LE(lines.size(), 120u);
  const std::vector<std::string> screen(lines.begin(),
                                        lines.begin() + std::min<long>(30, long(lines.size())));
  EXPECT_TRUE(any_line_has(screen, "    ./input_scripts/run"));
  EXPECT_TRUE(any_line_has(screen, "    ./tests/run"));
  EXPECT_TRUE(any_line_has(screen, ".png")) << "a picture in the first 30 lines";
  for (const char* link : {"](input_scripts/tutorials/README.md)", "](src_plugin/STYLES.md)"})
    EXPECT_TRUE(any_line_has(lines, link)) << link;
}

TEST(Documents, NameTheVersionOfTheBuild)
{
  std::string version;
  for (const std::string& line : lines_of(source / "CMakeLists.txt"))
    if (line.rfind("project(", 0) == 0) {
      const std::size_t word = line.find("VERSION ") + 8;
      version = line.substr(word, line.find(' ', word) - word);
    }
  ASSERT_FALSE(version.empty());
  EXPECT_TRUE(any_line_has(lines_of(source / "CITATION.cff"), "version: " + version)) << version;
  EXPECT_TRUE(any_line_has(lines_of(source / "CHANGELOG.md"), "## [" + version + "] - "))
      << version;
}

TEST(MarkdownLinks, AreFoundInBothWaysAndOutsideOfCode)
{
  const std::vector<Link> links =
      local_links({"See [one](a.md) and ![two](b.png \"title\").",
                   "<img src=\"c.png\" height=\"4\">", "    [code](no.md)", "```", "[code](no.md)",
                   "```", "`[code](no.md)` [far](https://host/d.md)", "[part](#here)"});
  ASSERT_EQ(links.size(), 4u);
  EXPECT_EQ(links[0].target, "a.md");
  EXPECT_EQ(links[1].target, "b.png");
  EXPECT_EQ(links[2].target, "c.png");
  EXPECT_EQ(links[2].line, 2);
  EXPECT_EQ(links[3].target, "#here");
}

TEST(MarkdownLinks, AreRefusedWhereFileOrHeadingIsMissing)
{
  const fs::path page = source / "tests/bench/README.md";
  EXPECT_EQ(problem_with("peers/README.md", page), "");
  EXPECT_EQ(problem_with("peers/README.md#ghosts-and-messages", page), "");
  EXPECT_NE(problem_with("peers/NONE.md", page), "");
  EXPECT_NE(problem_with("peers/README.md#nowhere", page), "");
  EXPECT_NE(problem_with("#nowhere", page), "");
}
