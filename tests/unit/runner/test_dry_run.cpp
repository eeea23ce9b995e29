// SPDX-License-Identifier: GPL-2.0-only
#include "runner/dry_run.h"
#include "runner/machine_speed.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

CaseSize size_with(double grains, double steps)
{
  CaseSize size;
  size.grains = grains;
  size.steps_after = steps;
  size.work = grains * steps;
  size.bytes = 40e6;
  return size;
}

}  // namespace

// 1e9 and 2e9 steps of a grain at 1e-7 s each: 100 and 200 s; half of the second is done.
TEST(DryRun, TellsWhatEachCaseAndTheWholeTake)
{
  const std::vector<ExpectedCase> cases{{"small", size_with(1e4, 0.5e5), 0.0, ""},
                                        {"large", size_with(1e5, 2e4), 0.0, ""},
                                        {"half", size_with(1e5, 2e4), 0.6, "60 % are done"},
                                        {"own", std::nullopt, 0.0, "its deck does not tell"}};
  EXPECT_EQ(dry_run_table(cases, {1, 1}, 1e-7, 5e9),
            "case    grains   steps  expected time   disk\n"
            "large  100 000  20 000          3 min  40 MB\n"
            "half   100 000  20 000           80 s  40 MB  60 % are done\n"
            "small   10 000  50 000           50 s  40 MB\n"
            "own          -       -              -      -  its deck does not tell\n"
            "4 cases, at once: 1, MPI ranks each: 1: 6 min, 120 MB of 5.0 GB that are free; "
            "without 1 of unknown size\n"
            "This machine takes 10.00 million steps of a grain in a second and rank, measured "
            "just now\n");
}

TEST(DryRun, OwnsThatNoSizeIsKnown)
{
  const std::vector<ExpectedCase> cases{{"own", std::nullopt, 0.0, "its deck does not tell"}};
  const std::string table = dry_run_table(cases, {1, 1}, 1e-7, 5e9);
  EXPECT_NE(table.find("\n1 case, at once: 1, MPI ranks each: 1: time and disk unknown, 5.0 GB are "
                       "free\nThis machine"),
            std::string::npos)
      << table;
}

// Two at once: 200 s beside 80 and 50; two ranks run each 1.85 times as fast.
TEST(DryRun, CountsRanksAndCasesAtOnce)
{
  const std::vector<ExpectedCase> cases{{"a", size_with(1e5, 2e4), 0.0, ""},
                                        {"b", size_with(1e5, 1e4), 0.0, ""}};
  EXPECT_NE(dry_run_table(cases, {1, 2}, 2e-7, 5e9).find("MPI ranks each: 1: 7 min,"),
            std::string::npos);
  EXPECT_NE(dry_run_table(cases, {2, 1}, 2e-7, 5e9).find("MPI ranks each: 2: 5 min,"),
            std::string::npos);
}

TEST(MachineSpeed, IsThatOfTheLastRunInTheLog)
{
  EXPECT_DOUBLE_EQ(
      seconds_per_grain_step("Loop time of 9 on 1 procs for 1000 steps with 3993 atoms, finish\n"
                             "Loop time of 0.5 on 2 procs for 500 steps with 4000 atoms, finish\n")
          .value(),
      5e-7);
  EXPECT_FALSE(seconds_per_grain_step("ERROR: no deck\n"));
}
