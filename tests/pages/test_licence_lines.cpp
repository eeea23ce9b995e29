// SPDX-License-Identifier: GPL-2.0-only
// Every source names its licence in one of its first two lines, the one that CITATION.cff has.
#include "pages/source_tree.h"
#include "pages/word_table.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;

bool is_source(const fs::path& file)
{
  static const std::set<std::string> endings{".cpp", ".h",   ".lmp", ".cmake",
                                             ".py",  ".css", ".html"};
  const fs::path made_from = file.extension() == ".in" ? file.stem() : file;
  if (endings.count(made_from.extension()) || file.filename() == "CMakeLists.txt") return true;
  char start[2] = {};
  std::ifstream(file).read(start, 2);
  return start[0] == '#' && start[1] == '!';
}

std::string licence_line()
{
  std::ifstream citation(source / "CITATION.cff");
  const std::string key = "license: ";
  for (std::string line; std::getline(citation, line);)
    if (line.rfind(key, 0) == 0) return "SPDX-License-Identifier: " + line.substr(key.size());
  return "";
}

bool has_in_two_lines(const fs::path& file, const std::string& words)
{
  std::ifstream text(file);
  std::string first, second;
  std::getline(text, first);
  std::getline(text, second);
  return (first + "\n" + second).find(words) != std::string::npos;
}

}  // namespace

TEST(LicenceLines, StandInEverySource)
{
  const std::string wanted = licence_line();
  ASSERT_FALSE(wanted.empty());
  int sources = 0;
  for (const fs::path& file : files_of_tree(source)) {
    if (!is_source(file)) continue;
    ++sources;
    EXPECT_TRUE(has_in_two_lines(file, wanted))
        << file << ": write 'tests/support/add_licence_lines'";
  }
  EXPECT_GT(sources, 600);
}

TEST(LicenceLines, AreNamedOnTheFirstPage)
{
  const std::string page = read_text(source / "README.md");
  EXPECT_NE(page.find("GPL-2.0-only"), std::string::npos);
  EXPECT_NE(page.find("(LICENSE)"), std::string::npos);
}
