// SPDX-License-Identifier: GPL-2.0-only
#include "runner/progress.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(Progress, IsZeroBeforeTheDeckSaysAnything)
{
  EXPECT_EQ(read_progress("").fraction, 0.0);
  EXPECT_EQ(read_progress("").stage, "starting");
}

TEST(Progress, IsThatOfTheLastWholeLine)
{
  const Progress p = read_progress("0.00 packing\n\n0.30 shear\n0.412 shear\n0.9");
  EXPECT_DOUBLE_EQ(p.fraction, 0.412);
  EXPECT_EQ(p.stage, "shear");
}

// From 1e-1 to 1e-5 are four decades: at 1e-3 two of them are done.
TEST(Progress, FollowsARatioOnItsLogarithm)
{
  const Progress p = read_progress(
      "0.2 0.6 consolidation ratio 1e-1 1e-5\n0.2 0.6 consolidation ratio 1e-3 1e-5\n");
  EXPECT_NEAR(p.fraction, 0.4, 1e-12);
  EXPECT_EQ(p.stage, "consolidation");
}

TEST(Progress, DoesNotGoBackWhileARatioSwings)
{
  const std::string falls = "0 1 c ratio 1e-1 1e-5\n0 1 c ratio 1e-3 1e-5\n";
  EXPECT_NEAR(read_progress(falls + "0 1 c ratio 1e-2 1e-5\n").fraction, 0.5, 1e-12);
}

TEST(Progress, BeginsAgainWithTheLargestRatioWhileAStressIsRaised)
{
  EXPECT_EQ(read_progress("0 1 c ratio 2e-5 1e-5\n0 1 c ratio 1e-1 1e-5\n").fraction, 0.0);
}

TEST(Progress, PassesOverLinesItCannotRead)
{
  for (const char* bad : {"nan shear\n", "shear\n", "0.5 0.6 c ratio x 1e-5\n", "1e999 shear\n",
                          "0.1 0.2 0.3\n", "\x01\x02 \x03\n"})
    EXPECT_DOUBLE_EQ(read_progress(std::string("0.25 packing\n") + bad).fraction, 0.25) << bad;
}

TEST(Progress, StaysBetweenNothingAndTheWhole)
{
  EXPECT_EQ(read_progress("7 shear\n").fraction, 1.0);
  EXPECT_EQ(read_progress("0 1 c ratio 1e-1 1e-5\n0 1 c ratio 1e-9 1e-5\n").fraction, 1.0);
}

// One of four cases has ended, two are half way: 2 of 4 in 80 s, one after the other.
TEST(Progress, LinesTellEachRunningCaseAndTheWhole)
{
  const std::vector<CaseClock> clocks{{1.0, 0.0, 1.0, 40.0, true, true},
                                      {1.0, 0.0, 0.5, 20.0, true, false},
                                      {1.0, 0.0, 0.5, 20.0, true, false},
                                      {1.0}};
  const std::vector<RunningCase> running{{"plain_050", {0.5, "shear"}}, {"own", {0.5, "shear"}}};
  EXPECT_EQ(progress_lines(running, clocks, 1),
            (std::vector<std::string>{"plain_050  50 % shear", "own        50 % shear",
                                      "1 of 4 ended, 50 % done, 80 s left"}));
}

TEST(Progress, LinesGuessNoTimeAtTheStart)
{
  EXPECT_EQ(progress_lines({{"a", {}}}, {{1.0, 0.0, 0.0, 3.0, true, false}}, 1).back(),
            "0 of 1 ended, 0 % done");
}

TEST(Progress, LastLineOfASeriesAsksForNoOtherOption)
{
  Left left;
  left.resumable = {{"a", 4}};
  left.begin_again = {"b"};
  EXPECT_EQ(stopped_line(left),
            "Stopped; --resume goes on with a from stage 4, and begins again with b");
  left.series = true;
  EXPECT_EQ(stopped_line(left),
            "Stopped; the same command goes on with a from stage 4, and begins again with b");
}

TEST(Progress, TellsTimeInTheUnitThatFits)
{
  EXPECT_EQ(in_time(45.2), "45 s");
  EXPECT_EQ(in_time(125.0), "2 min");
  EXPECT_EQ(in_time(7500.0), "2 h 05 min");
}
