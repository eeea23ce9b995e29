// SPDX-License-Identifier: GPL-2.0-only
// Includes of src_plugin run downwards: the order of the floors is data in floors.txt.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace {

using Include = std::pair<std::string, std::string>;  // file, what it includes

struct Floors {
  std::map<std::string, int> level;                   // of a folder or a file beside the folders
  std::map<std::string, std::set<std::string>> only;  // what a floor alone may include
};

Floors read_floors(std::istream& lines)
{
  Floors floors;
  int level = 0;
  for (std::string line, word; std::getline(lines, line);) {
    std::istringstream words(line);
    if (!(words >> word)) continue;
    if (word == "floor") {
      ++level;
      while (words >> word) floors.level[word] = level;
    } else if (word == "only" && words >> word) {
      std::set<std::string>& allowed = floors.only[word];
      allowed.insert(word);
      while (words >> word) allowed.insert(word);
    }
  }
  return floors;
}

/// The name by which floors.txt knows the file `path`, relative to src_plugin.
std::string floor_name(const fs::path& path)
{
  return path.has_parent_path() ? path.begin()->string() : path.stem().string();
}

std::vector<Include> includes_of(const fs::path& root)
{
  static const std::regex form(R"re(\s*#\s*include\s+"([^"]+)".*)re");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string ending = entry.path().extension();
    if (ending != ".h" && ending != ".cpp") continue;
    const fs::path file = fs::relative(entry.path(), root);
    std::ifstream text(entry.path());
    std::smatch include;
    for (std::string line; std::getline(text, line);)
      if (std::regex_match(line, include, form) && fs::exists(root / include.str(1)))
        found.emplace_back(file.string(), include.str(1));
  }
  return found;
}

/// One line for each include of the tree at `root` that `floors` does not allow.
std::vector<std::string> complaints(const fs::path& root, const Floors& floors)
{
  std::vector<std::string> lines;
  for (const Include& include : includes_of(root)) {
    const std::string from = floor_name(include.first), to = floor_name(include.second);
    const auto only = floors.only.find(from);
    const std::string arrow = include.first + " includes " + include.second;
    if (floors.level.count(from) == 0 || floors.level.count(to) == 0)
      lines.push_back(include.first + " or " + include.second + " is on no floor");
    else if (floors.level.at(to) > floors.level.at(from))
      lines.push_back(arrow + ", which is above it");
    else if (only != floors.only.end() && only->second.count(to) == 0)
      lines.push_back(arrow + ", which its floor may not");
  }
  return lines;
}

}  // namespace

TEST(Floors, OfThePluginHaveNoIncludeUpwards)
{
  const fs::path source = ENCASE_SOURCE;
  std::ifstream data(source / "tests/unit/floors/floors.txt");
  const Floors floors = read_floors(data);
  ASSERT_GT(floors.level.size(), 10u);
  ASSERT_EQ(floors.only.count("host"), 1u);
  EXPECT_GT(includes_of(source / "src_plugin").size(), 300u);
  for (const std::string& complaint : complaints(source / "src_plugin", floors))
    ADD_FAILURE() << complaint;
}

TEST(Floors, AreWatchedFromAFolderAndFromAFileBesideIt)
{
  const encased_column::testing::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    fs::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << text;
  };
  write("low/a.h", "#include <vector>\n#include \"lammps.h\"\n");
  write("low/up.cpp", "#include \"low/a.h\"\n  #  include \"high/b.h\"  // no\n");
  write("middle/d.h", "#include \"low/a.h\"\n");
  write("middle/e.h", "#include \"middle/d.h\"\n");
  write("tight/f.h", "#include \"low/a.h\"\n#include \"middle/d.h\"\n#include \"tight/g.h\"\n");
  write("tight/g.h", "");
  write("high/b.h", "#include \"low/a.h\"\n");
  write("top.h", "#include \"high/b.h\"\n");
  write("aside/c.h", "#include \"low/a.h\"\n");
  std::istringstream data(
      "# a comment\nfloor low\nfloor middle\nfloor tight\nonly tight low\nfloor high\nfloor top\n");
  std::vector<std::string> found = complaints(folder.path(), read_floors(data));
  std::sort(found.begin(), found.end());
  const std::vector<std::string> expected{"aside/c.h or low/a.h is on no floor",
                                          "low/up.cpp includes high/b.h, which is above it",
                                          "tight/f.h includes middle/d.h, which its floor may not"};
  EXPECT_EQ(found, expected);
}
