// SPDX-License-Identifier: GPL-2.0-only
#include "shell/touched_nodes.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// Rank 1 of three: what the others say at each call is known, what this one says is seen.
struct BetweenTwo {
  using Rows = std::vector<double>;
  std::vector<Rows> first, last;
  mutable std::vector<Rows> said = {};

  void gather(const double* mine, const int* counts, const int* starts, double* all) const
  {
    const std::size_t call = said.size();
    said.emplace_back(mine, mine + counts[1]);
    const Rows* const rows[] = {&first.at(call), &said.back(), &last.at(call)};
    for (int r = 0; r < 3; ++r) {
      ASSERT_EQ(counts[r], static_cast<int>(rows[r]->size())) << "of rank " << r;
      std::copy(rows[r]->begin(), rows[r]->end(), all + starts[r]);
    }
  }
  void sum(double* numbers, std::size_t count) const
  {
    said.emplace_back(numbers, numbers + count);
  }
};

BetweenTwo::Rows loads(const std::vector<double>& numbers)
{
  BetweenTwo::Rows rows;
  for (const double x : numbers) rows.insert(rows.end(), {x, 0.0, 0.0, 0.0, 10.0 * x, 0.0});
  return rows;
}

}  // namespace

// A strip of four facets; ours is the second one, and a grain is near the third.
TEST(TouchedNodes, AreAllThatASumOverRanksCarries)
{
  const std::vector<Facet> facet{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  TouchedNodes touched(6, 3);
  const BetweenTwo ranks{{{3}, {0, 1, 2}, loads({1, 2, 3})},
                         {{4}, {2, 3, 4, 5}, loads({100, 200, 300, 400})}};
  touched.list(facet, 1, 2, {2, 2}, ranks);
  EXPECT_EQ(ranks.said[0], BetweenTwo::Rows{4});
  EXPECT_EQ(ranks.said[1], (BetweenTwo::Rows{1, 2, 3, 4}));

  std::vector<Vec3> load(12, Vec3::Zero());
  for (int i = 1; i < 5; ++i) load[i].x() = 10.0 * i, load[6 + i].y() = 100.0 * i;
  touched.sum(load, ranks);
  EXPECT_EQ(ranks.said[2], loads({10, 20, 30, 40}));
  const double expected[] = {1, 2 + 10, 3 + 20 + 100, 30 + 200, 40 + 300, 400};
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(load[i], Vec3(expected[i], 0, 0)) << i;
    EXPECT_EQ(load[6 + i], Vec3(0, 10 * expected[i], 0)) << i;
  }
}

// In floating point the sum is 0 only from left to right.
TEST(TouchedNodes, AreSummedInTheOrderOfTheRanks)
{
  TouchedNodes touched(3, 3);
  const BetweenTwo ranks{{{1}, {0}, loads({1e20})}, {{1}, {0}, loads({-1e20})}};
  touched.list({{0, 1, 2}}, 0, 1, {}, ranks);
  std::vector<Vec3> load(6, Vec3::Zero());
  load[0].x() = 1.0;
  load[1].x() = 2.0;
  touched.sum(load, ranks);
  EXPECT_EQ(load[0].x(), 0.0);
  EXPECT_EQ(load[1].x(), 2.0);
}

// Three nodes that all three ranks touch are nine to send: more than twice three.
TEST(TouchedNodes, AreNotToldWhereAllTouchAll)
{
  TouchedNodes touched(3, 3);
  const BetweenTwo ranks{{{3}, {0, 1, 2}}, {{3}, {0, 1, 2}}};
  touched.list({{0, 1, 2}}, 0, 1, {}, ranks);
  std::vector<Vec3> load(6, Vec3::Ones());
  touched.sum(load, ranks);
  EXPECT_EQ(ranks.said[2], BetweenTwo::Rows(18, 1.0));
}

// A list that is made anew forgets the facets that were near.
TEST(TouchedNodes, FollowTheGrains)
{
  const std::vector<Facet> facet{{0, 1, 2}, {3, 4, 5}};
  TouchedNodes touched(6, 3);
  const BetweenTwo before{{{0}, {}}, {{0}, {}}}, after{{{0}, {}}, {{0}, {}}};
  touched.list(facet, 0, 1, {1}, before);
  touched.list(facet, 0, 1, {}, after);
  EXPECT_EQ(before.said[1].size(), 6u);
  EXPECT_EQ(after.said[1], (BetweenTwo::Rows{0, 1, 2}));
}
