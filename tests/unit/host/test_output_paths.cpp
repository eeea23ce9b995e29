// SPDX-License-Identifier: GPL-2.0-only
#include "host/output_paths.h"

#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;

namespace fs = std::filesystem;

TEST(OutputPaths, BelongToTheirFirstOwnerUntilHeReleasesThem)
{
  OutputPaths paths;
  EXPECT_EQ(paths.claim("/no/a.csv", "one"), "");
  EXPECT_EQ(paths.claim("/no/b.csv", "one"), "");
  EXPECT_EQ(paths.claim("/no/a.csv", "two"), "one");
  paths.release("two");
  EXPECT_EQ(paths.claim("/no/a.csv", "two"), "one") << "what was refused is not released";
  paths.release("one");
  EXPECT_EQ(paths.claim("/no/a.csv", "two"), "");
  EXPECT_EQ(paths.claim("/no/b.csv", "two"), "");
}

TEST(OutputPaths, AreClaimedTwiceByOneOwnerOnlyIfHeRepeatsWhatHeWrote)
{
  OutputPaths paths;
  EXPECT_EQ(paths.claim("/no/a.stl", "command", true), "");
  EXPECT_EQ(paths.claim("/no/a.stl", "command", true), "");
  EXPECT_EQ(paths.claim("/no/a.stl", "command"), "command");
}

TEST(OutputPaths, OfOneFileAreTheSameByEveryWayToIt)
{
  const TemporaryFolder folder;
  const fs::path root = folder.path();
  fs::create_directories(root / "deep");
  fs::create_directory_symlink(root / "deep", root / "link");
  std::ofstream(root / "deep" / "there.csv") << "x";
  fs::create_hard_link(root / "deep" / "there.csv", root / "second.csv");
  const std::string there = root / "deep" / "there.csv", coming = root / "deep" / "coming.csv";
  for (const fs::path& other : {root / "link" / "there.csv", root / "deep" / ".." / "second.csv"})
    EXPECT_TRUE(is_same_file(there, other)) << other;
  for (const fs::path& other : {root / "link" / "coming.csv", root / "deep" / "." / "coming.csv"})
    EXPECT_TRUE(is_same_file(coming, other)) << other << ", not made yet";
  EXPECT_FALSE(is_same_file(there, coming));
}

TEST(OutputPaths, KnowWhatThisProcessHoldsOpenToWrite)
{
  const TemporaryFolder folder;
  const std::string file = folder.path() / "log";
  EXPECT_FALSE(is_open_for_writing(file)) << "not there";
  {
    const std::ofstream log(file);
    EXPECT_TRUE(is_open_for_writing(file));
  }
  const std::ifstream reader(file);
  EXPECT_FALSE(is_open_for_writing(file)) << "open to be read only";
}
