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

// One of four cases has ended, another is half way: 1.5 of 4 in 60 s, so 2.5 take 100 s.
TEST(Progress, LineTellsTheTimeLeft)
{
  EXPECT_EQ(progress_line({{"plain_050", {0.5, "shear"}}}, 1, 4, 60.0, 0.0),
            "plain_050 shear 50 % | 37 % done, 2 min left");
}

// What a case that goes on brings with it was not done in this time.
TEST(Progress, LineCountsTheWorkOfThisRunOnly)
{
  EXPECT_EQ(progress_line({{"a", {0.75, "shear"}}}, 0, 1, 50.0, 0.5),
            "a shear 75 % | 75 % done, 50 s left");
}

TEST(Progress, TellsTimeInTheUnitThatFits)
{
  EXPECT_EQ(in_time(45.2), "45 s");
  EXPECT_EQ(in_time(125.0), "2 min");
  EXPECT_EQ(in_time(7500.0), "2 h 05 min");
}
