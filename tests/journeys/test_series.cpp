// SPDX-License-Identifier: GPL-2.0-only
// A series is one command: what is missing runs, whatever happened before, and a table tells what
// became of each case.
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> whole_series{"--series", "all", "--jobs", "2",
                                            "--ranks",  "1",   "--set",  "strain_end=0.005"};

bool has(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

}  // namespace

// The encased case is the longer one: it begins first though its row is the second one.
TEST(Series, KilledInTheMiddleHasTheTableOfOneThatWasNot)
{
  const TemporaryFolder folder;
  prepare_small_cases(folder.path());
  const Outcome whole = RunningCommand(folder.path(), "whole", whole_series).end();
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  EXPECT_TRUE(whole.says("Running encased plain")) << whole.output;
  // Their `limit` is ten times what the checks allow, though one may end below that.
  EXPECT_TRUE(whole.says("  checks missed  unbalanced force ratio")) << whole.output;
  {
    RunningCommand command(folder.path(), "killed", whole_series);
    ASSERT_TRUE(command.wait_until([&] {
      return fs::exists(folder.path() / "killed/plain/restart_4") &&
             fs::exists(folder.path() / "killed/encased/restart_2");
    }));
    command.send(SIGKILL);
    EXPECT_EQ(command.end().exit_code, 137);
  }
  EXPECT_FALSE(fs::exists(folder.path() / "killed/encased/finished"));
  const Outcome again = RunningCommand(folder.path(), "killed", whole_series).end();
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_TRUE(again.says("Case encased goes on in stage ")) << again.output;
  for (const char* file : {"cases.txt", "table.txt", "checks.txt"})
    EXPECT_EQ(read_text(folder.path() / "killed" / file), read_text(folder.path() / "whole" / file))
        << file;

  const Outcome third = RunningCommand(folder.path(), "killed", whole_series).end();
  EXPECT_EQ(third.exit_code, 0) << third.output;
  EXPECT_TRUE(third.says("Case encased is kept as it is")) << third.output;
  EXPECT_FALSE(third.says("Running")) << third.output;
}

TEST(Series, RetriesWhatFailedOnlyWhereItIsAskedTo)
{
  const TemporaryFolder folder;
  const std::string good = "variable speed index 3\nrecord_variables file variables.csv\n";
  std::ofstream(folder.path() / "good.lmp") << good;
  std::ofstream(folder.path() / "bad.lmp") << good << "require variable speed between 0 1\n";
  std::ofstream(folder.path() / "small.csv")
      << "id,deck,variables,series\ngood,good.lmp,,some\nbad,bad.lmp,,some\nother,bad.lmp,,\n";
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--series", "some"});
    return RunningCommand(folder.path(), "out", more).end();
  };
  const Outcome first = run({});
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_TRUE(first.says("Case bad failed: exit code 1, see ")) << first.output;
  const std::string table = read_text(folder.path() / "out/cases.txt");
  EXPECT_TRUE(has(table, "good  passed\n")) << table;
  EXPECT_TRUE(has(table, "bad   failed   ERROR")) << table;
  EXPECT_FALSE(has(table, "other")) << table;

  const Outcome second = run({});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_TRUE(second.says("Case bad failed before and is left so (--retry would run it): ERROR"))
      << second.output;
  EXPECT_FALSE(second.says("Running")) << second.output;
  EXPECT_EQ(read_text(folder.path() / "out/cases.txt"), table);

  const Outcome third = run({"--retry"});
  EXPECT_TRUE(third.says("Running bad;")) << third.output;
  EXPECT_TRUE(third.says("Case bad failed: exit code 1, see ")) << third.output;
}
