// SPDX-License-Identifier: GPL-2.0-only
#include "runner/run_options.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(Schedule, RunsCasesSideBySideWhereThatFillsTheMachine)
{
  const Schedule s = best_schedule(6, 2);
  EXPECT_EQ(s.ranks, 1);
  EXPECT_EQ(s.jobs, 2);
}

// One case alone leaves three of four cores idle: 4 ranks take 1 / 3.3 of the time.
TEST(Schedule, GivesOneCaseAllCores)
{
  const Schedule s = best_schedule(1, 4);
  EXPECT_EQ(s.ranks, 4);
  EXPECT_EQ(s.jobs, 1);
}

// On 4 cores 6 cases take 2 rounds of 1 rank, 3 rounds of 2 in 3 / 1.85 = 1.62 rounds' time, 6 of 4
// in 6 / 3.3 = 1.82.
TEST(Schedule, WeighsAnIdleLastRoundAgainstTheLossOfSeveralRanks)
{
  const Schedule s = best_schedule(6, 4);
  EXPECT_EQ(s.ranks, 2);
  EXPECT_EQ(s.jobs, 2);
}

TEST(Schedule, KeepsWhatIsGiven)
{
  EXPECT_EQ(best_schedule(6, 4, 3).ranks, 3);
  EXPECT_EQ(best_schedule(6, 4, 3).jobs, 1);
  EXPECT_EQ(best_schedule(6, 4, 8).jobs, 1) << "more ranks than cores still run one case";
  EXPECT_EQ(best_schedule(6, 4, 0, 5).jobs, 5);
}
