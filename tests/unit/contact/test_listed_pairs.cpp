// SPDX-License-Identifier: GPL-2.0-only
#include "contact/listed_pairs.h"

#include <gtest/gtest.h>

#include <malloc.h>

#include <vector>

using namespace encased_column;

namespace {

/// A list of `count` pairs (n, n + 100), whose contacts remember two numbers, the second of them
/// the step.
ListedPairs list_of(int count)
{
  ListedPairs pairs;
  pairs.start(2, 1);
  for (int n = 0; n < count; ++n) pairs.add(n, n + 100);
  pairs.end();
  return pairs;
}

void touch(ListedPairs& pairs, int n, double number, double step)
{
  pairs.memory(n)[0] = number;
  pairs.memory(n)[1] = step;
}

}  // namespace

TEST(ListedPairs, RememberNothingBeforeTheyTouch)
{
  ListedPairs pairs = list_of(3);
  EXPECT_EQ(pairs.memory_of_touching(1), nullptr);
  EXPECT_EQ(pairs.memory(1)[0], 0.0);
  EXPECT_EQ(pairs.memory(1)[1], 0.0);
}

TEST(ListedPairs, GiveOnOnlyWhatTouchedInTheLastStep)
{
  ListedPairs pairs = list_of(4);
  touch(pairs, 0, 5.0, 9.0);
  touch(pairs, 3, 7.0, 9.0);
  pairs.set_step(9.0);
  touch(pairs, 3, 8.0, 10.0);
  pairs.set_step(10.0);
  EXPECT_EQ(pairs.memory_of_touching(0), nullptr);  // has parted
  EXPECT_EQ(pairs.memory_of_touching(2), nullptr);  // never met
  ASSERT_NE(pairs.memory_of_touching(3), nullptr);
  EXPECT_EQ(pairs.memory_of_touching(3)[0], 8.0);
}

TEST(ListedPairs, KeepTheMemoryOfThoseThatWereGiven)
{
  const double memory[] = {3.0, 12.0}, stale[] = {4.0, 11.0};
  ListedPairs pairs = list_of(3);
  pairs.restore(2, memory);
  pairs.restore(1, stale);
  ASSERT_NE(pairs.memory_of_touching(2), nullptr);
  EXPECT_EQ(pairs.memory_of_touching(2)[0], 3.0);
  EXPECT_EQ(pairs.memory_of_touching(1), nullptr);
}

TEST(ListedPairs, ForgetAllWithANewList)
{
  ListedPairs pairs = list_of(2);
  touch(pairs, 0, 5.0, 9.0);
  pairs.set_step(9.0);
  pairs.start(2, 1);
  pairs.add(4, 6);
  pairs.end();
  ASSERT_EQ(pairs.size(), 1);
  EXPECT_EQ(pairs.first()[0], 4);
  EXPECT_EQ(pairs.second()[0], 6);
  EXPECT_EQ(pairs.memory_of_touching(0), nullptr);
}

// A batch of contacts holds on to the memories of some while others touch for the first time.
TEST(ListedPairs, LeaveMemoriesWhereTheyAre)
{
  const int count = 1000;
  ListedPairs pairs = list_of(count);
  std::vector<double*> before;
  for (int n = count - 1; n >= 0; --n) before.push_back(pairs.memory(n));
  for (int n = 0; n < count; ++n) EXPECT_EQ(pairs.memory(n), before[count - 1 - n]);
}

TEST(ListedPairs, TakeInMoreThatAreNotThereYetInTheRowsOfTheirFirstGrains)
{
  ListedPairs pairs;
  pairs.start(2, 1);
  for (const auto& [i, j] : {std::pair(0, 1), {0, 4}, {2, 3}, {2, 9}}) pairs.add(i, j);
  pairs.end();
  touch(pairs, 1, 7.0, 1.0);
  touch(pairs, 3, 8.0, 1.0);
  pairs.set_step(1.0);
  pairs.insert({{2, 5}, {3, 4}, {0, 4}, {1, 6}, {0, 3}, {1, 6}, {2, 9}});
  const std::vector<int> first(pairs.first(), pairs.first() + pairs.size());
  const std::vector<int> second(pairs.second(), pairs.second() + pairs.size());
  EXPECT_EQ(first, (std::vector<int>{0, 0, 0, 1, 2, 2, 2, 3}));
  EXPECT_EQ(second, (std::vector<int>{1, 4, 3, 6, 3, 9, 5, 4}));
  for (int n = 0; n < pairs.size(); ++n)
    EXPECT_EQ(pairs.memory_of_touching(n) != nullptr, n == 1 || n == 5) << n;
  EXPECT_EQ(pairs.memory_of_touching(1)[0], 7.0);
  EXPECT_EQ(pairs.memory_of_touching(5)[0], 8.0);
  EXPECT_EQ(pairs.memory(4)[0], 0.0);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)  // which has a heap of its own
// Blocks of that size are mapped one by one: the C library tells how many bytes are.
TEST(ListedPairs, LeaveTheMemoryOfTheirMemoriesWhileANewListIsMade)
{
  constexpr int count = 10000000;
  ListedPairs pairs = list_of(count);
  const std::size_t with_list = mallinfo2().hblkhd;
  pairs.start(2, 1);
  EXPECT_LE(mallinfo2().hblkhd + count * (sizeof(int) + 2 * sizeof(double)), with_list);
}
#endif
