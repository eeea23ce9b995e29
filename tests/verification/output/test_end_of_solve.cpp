// SPDX-License-Identifier: GPL-2.0-only
// `solve` ends as a `run` of as many steps does: the same last line of the host's table, the same
// files, and its checks are made.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Two grains at rest between platens; the ratio is at its limit after 600 steps, which `thermo`
/// and `dump` do or do not divide.
std::string deck(const std::string& steps, const std::string& lines)
{
  return opening_deck("two_grains") + R"(
unfix          move
fix            move all motion every 50
fix            pictures all output/grains every 100000 folder grains compress no
thermo_style   custom step atoms ke f_move[1]
)" + lines +
         steps + "\nfix_modify pictures write now\n";
}

/// The host's table: its lines that begin with a number.
std::vector<std::string> table_of(const Outcome& outcome)
{
  std::vector<std::string> table;
  for (const std::string& line : outcome.lines())
    if (!line.empty() && line.find_first_not_of("0123456789.e+- ") == std::string::npos)
      table.push_back(line);
  return table;
}

std::map<std::string, std::string> files_of(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder);
    if (entry.is_regular_file() && name != "in.lmp" && name != "log.liggghts")
      files[name] = read_text(entry.path());
  }
  return files;
}

void expect_the_same(const std::string& lines)
{
  const TemporaryFolder solved, run;
  const Outcome a = run_deck(deck("solve ratio average 1e9 every 200 least 500 max 2000", lines), 1,
                             solved.path());
  const Outcome b = run_deck(deck("run 600", lines), 1, run.path());
  ASSERT_EQ(a.exit_code, 0) << a.output;
  ASSERT_EQ(b.exit_code, 0) << b.output;
  EXPECT_EQ(table_of(a), table_of(b)) << lines;
  EXPECT_EQ(files_of(solved.path()), files_of(run.path())) << lines;
}

}  // namespace

TEST(EndOfSolve, IsThatOfARun)
{
  expect_the_same("");
  expect_the_same("thermo 170\ndump d all custom 130 d.* id x y z fx\nrestart 250 r.*\n");
  // At the step of a look, and after it again.
  expect_the_same("thermo 100\ndump d all custom 100 d.* id x y z fx\nrestart 200 r.*\n");
  expect_the_same("variable when equal step+90\nthermo v_when\n");
}

// From `least` steps to the end; the next run has that of the motion again.
TEST(EndOfSolve, WithADampingOfItsOwnIsThatOfRunsWithIt)
{
  const std::string falls = opening_deck("one_grain") + R"(
unfix move
fix   move all motion
fix   weight all gravity 9.8 vector 0 0 -1
fix   bottom all servo/platen position bottom z -0.01 area 0.01 type 2
fix   pictures all output/grains every 100000 folder grains compress no
thermo_style custom step ke f_move[1] f_move[5] f_bottom[2]
)";
  const std::string write = "fix_modify pictures write now\n";
  const TemporaryFolder solved, run;
  const Outcome a = run_deck(falls +
                                 "solve ratio average 1e-6 every 50 least 75 damping 0.1\n"
                                 "variable end equal step\nprint \"end ${end}\"\nrun 100\n" +
                                 write,
                             1, solved.path());
  ASSERT_EQ(a.exit_code, 0) << a.output;
  const double end = a.value("end");
  ASSERT_GE(end, 200.0);
  const Outcome b = run_deck(falls + "run 75\nfix_modify move damping 0.1\nrun " +
                                 std::to_string(std::lround(end) - 75) +
                                 "\nfix_modify move damping 0.7\nrun 100\n" + write,
                             1, run.path());
  ASSERT_EQ(b.exit_code, 0) << b.output;
  EXPECT_EQ(table_of(a).back(), table_of(b).back());
  EXPECT_EQ(files_of(solved.path()), files_of(run.path()));
}

TEST(EndOfSolve, SeesAGrainThatLeftInItsLastStep)
{
  const std::string away =
      "thermo_modify lost error\ngroup one id 1\nvelocity one set 0 0 200 units box\n";
  for (const std::string steps :
       {"run 100", "solve ratio average 1e9 every 100 max 2000 least 100"}) {
    const Outcome outcome = run_deck(deck(steps, away));
    EXPECT_NE(outcome.exit_code, 0) << steps;
    EXPECT_TRUE(outcome.says("of 2 grains 1 are left at step 100: the others left the box"))
        << outcome.output;
  }
}
