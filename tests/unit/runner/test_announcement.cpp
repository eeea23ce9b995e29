// SPDX-License-Identifier: GPL-2.0-only
// What is said before cases run: how much, how long here, where to.
#include "runner/announcement.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

ExpectedCase case_with(double grains, double steps, double done = 0.0)
{
  CaseSize size;
  size.grains = grains;
  size.steps_after = steps;
  size.work = grains * steps;
  size.bytes = 40e6;
  return {"a", size, done, ""};
}

}  // namespace

// 1e9 and half of 2e9 steps of a grain at 1e-7 s, one after the other: 200 s.
TEST(Announcement, TellsHowLongItTakesHere)
{
  const std::vector<ExpectedCase> cases{case_with(1e4, 1e5), case_with(2e4, 1e5, 0.5)};
  EXPECT_TRUE(takes_minutes(cases, {1, 1}));
  EXPECT_EQ(announcement(cases, {1, 1}, 1e-7, {"runs/default", 5e9, true}),
            "2 tests of 10 000 to 20 000 grains; results go to runs/default, 80 MB of 5.0 GB that "
            "are free\n"
            "Expected on this machine: 3 min (its speed was measured), then 18 s for tables and "
            "pictures\n"
            "Ctrl-C stops at any moment, the same command with --resume goes on\n");
}

TEST(Announcement, MeasuresNothingForWhatIsShort)
{
  const std::vector<ExpectedCase> cases{case_with(100, 1e5), {"own", std::nullopt, 0.0, ""}};
  EXPECT_FALSE(takes_minutes(cases, {1, 1}));
  EXPECT_EQ(
      announcement(cases, {1, 1}, std::nullopt, {"out", 5e9, false}),
      "2 tests of 100 grains (1 of unknown size); results go to out, 40 MB and more of 5.0 GB that "
      "are free\n"
      "Expected on this machine: a minute at most without what is of unknown size\n"
      "Ctrl-C stops at any moment, the same command with --resume goes on\n");
}

TEST(Announcement, OwnsThatASizeIsNotKnown)
{
  const std::vector<ExpectedCase> cases{{"own", std::nullopt, 0.0, ""}};
  EXPECT_EQ(announcement(cases, {1, 1}, std::nullopt, {"out", 5e9, true}),
            "1 test (1 of unknown size); results go to out, 5.0 GB are free there\n"
            "Expected on this machine: unknown, then 14 s for tables and pictures\n"
            "Ctrl-C stops at any moment, the same command with --resume goes on\n");
}

TEST(Announcement, OwnsThatASpeedIsNotKnown)
{
  EXPECT_NE(announcement({case_with(1e4, 1e6)}, {1, 1}, std::nullopt, {"out", 5e9, false})
                .find("Expected on this machine: unknown, its speed cannot be measured\n"),
            std::string::npos);
}
