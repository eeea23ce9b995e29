// SPDX-License-Identifier: GPL-2.0-only
// Where files go is settled when the deck names them: a later `shell cd` changes nothing.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <map>

using namespace encased_column::testing;

namespace {

namespace fs = std::filesystem;

/// Every writer of the plugin about the stack of grains, and what a deck does between two runs.
std::string deck_of_all_writers(const std::string& between)
{
  return opening_deck("grain_stack") +
         "fix side all mesh/surface/shell cylinder 0.05 0 0.08 edge 0.02 type 2 platens top bottom "
         "modulus 1.15e7 poisson 0.3 thickness 0.01 density 30\n"
         "fix top all servo/platen position top z 0.08 side side type 2\n"
         "fix bottom all servo/platen position bottom z 0 side side type 2\n"
         "fix move all motion step 1.0 every 10\n"
         "fix history all specimen/history platens top bottom side side motion move every 10\n"
         "fix balls all measure/sphere sphere 0 0 0.04 0.03 every 10 folder spheres\n"
         "fix grains all output/grains every 10 folder pictures/grains\n"
         "fix contacts all output/contacts every 10 rows 10 folder pictures/contacts\n"
         "fix sleeve all output/sleeve sleeve side every 10 rows 10 folder sleeve\n"
         "fix together all output/collection part grains part sleeve file together.pvd\n"
         "fix save all output/restart every 10 file save\n"
         "run 10\n" +
         between + "run 10\nfix_modify grains write now\nfix_modify history reference\nrun 10\n";
}

/// All files under `folder` with their bytes, but for the deck, the log, which holds times, and the
/// restart file.
std::map<std::string, std::string> files_under(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder);
    if (entry.is_regular_file() && name != "log.liggghts" && name != "save" && name != "in.lmp")
      files[name] = read_text(entry.path());
  }
  return files;
}

}  // namespace

TEST(FolderOfFiles, StaysWhereTheDeckNamedThem)
{
  const TemporaryFolder staying, leaving;
  const Outcome stayed = run_deck(deck_of_all_writers(""), 1, staying.path());
  const Outcome left = run_deck(deck_of_all_writers("shell mkdir elsewhere\nshell cd elsewhere\n"),
                                1, leaving.path());
  ASSERT_EQ(stayed.exit_code, 0) << stayed.output;
  ASSERT_EQ(left.exit_code, 0) << left.output;
  EXPECT_TRUE(fs::is_empty(leaving.path() / "elsewhere"));
  EXPECT_TRUE(fs::exists(leaving.path() / "save"));
  auto expected = files_under(staying.path());
  for (auto& [name, bytes] : files_under(leaving.path())) {
    EXPECT_TRUE(bytes == expected[name]) << name;
    expected.erase(name);
  }
  for (const auto& [name, bytes] : expected) ADD_FAILURE() << name << " is missing";
}
