// SPDX-License-Identifier: GPL-2.0-only
#include "runner/time_left.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

CaseClock half_way(double work, double seconds)
{
  return {work, 0.0, 0.5, seconds, true, false};
}

}  // namespace

TEST(TimeLeft, IsUnknownBeforeAnythingIsDone)
{
  EXPECT_FALSE(seconds_left({{1.0}, {2.0}}, 2));
  EXPECT_FALSE(seconds_left({{1.0, 0.0, 0.0, 5.0, true, false}}, 1));
}

// Half of a work of 4 took 20 s, so a unit takes 10 s: the rest of it 20 s, the others 30 and 20.
TEST(TimeLeft, OfOneAfterTheOtherIsTheSum)
{
  EXPECT_DOUBLE_EQ(*seconds_left({half_way(4.0, 20.0), {3.0}, {2.0}}, 1), 70.0);
}

// Of two places the free one takes 3, the other one 2 as soon as its 2 are done: both 30 and 40 s.
TEST(TimeLeft, OfSeveralPlacesIsThatOfTheLastToEnd)
{
  EXPECT_DOUBLE_EQ(*seconds_left({half_way(4.0, 20.0), {3.0}, {2.0}}, 2), 40.0);
  EXPECT_DOUBLE_EQ(*seconds_left({half_way(4.0, 20.0), {3.0}, {2.0}}, 9), 30.0);
}

// What a case that goes on brings with it was not done in this time: a quarter took 50 s.
TEST(TimeLeft, CountsTheWorkOfThisStartOnly)
{
  EXPECT_DOUBLE_EQ(*seconds_left({{1.0, 0.5, 0.75, 50.0, true, false}}, 1), 50.0);
  EXPECT_DOUBLE_EQ(*seconds_left({half_way(1.0, 10.0), {1.0, 0.75, 0.75}}, 1), 15.0);
}

TEST(TimeLeft, HoldsNothingOfACaseThatFailed)
{
  EXPECT_DOUBLE_EQ(*seconds_left({{1.0, 0.0, 0.5, 10.0, true, true}, half_way(1.0, 10.0)}, 1),
                   10.0);
}

TEST(TimeLeft, OfAllFillsThePlacesInOrder)
{
  EXPECT_DOUBLE_EQ(seconds_of_all({3.0, 2.0, 2.0, 2.0}, 0.5, 2), 2.5);
  EXPECT_DOUBLE_EQ(seconds_of_all({2.0, 2.0, 2.0, 3.0}, 0.5, 2), 2.5);
  EXPECT_DOUBLE_EQ(seconds_of_all({}, 0.5, 2), 0.0);
}

TEST(LargestFirst, SortsByWorkAndKeepsTheOrderOfEqualOnes)
{
  EXPECT_EQ(largest_first({1.0, 3.0, 2.0, 3.0, 1.0}), (std::vector<std::size_t>{1, 3, 2, 0, 4}));
}
