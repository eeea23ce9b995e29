// SPDX-License-Identifier: GPL-2.0-only
#include "contact/touching_pairs.h"

#include <gtest/gtest.h>

#include <vector>

using namespace encased_column;

// Balls in a line, each pair with a gap of its own choice.
TEST(TouchingPairs, AreThoseWithoutAGapInTheirOrder)
{
  const std::vector<double> gap{-1e-9, 1e-9, -0.5, 0.3, -1e-3, 2.0};
  std::vector<double> center, radius;
  std::vector<int> first, second;
  for (std::size_t n = 0; n < gap.size(); ++n) {
    const double y = 10.0 * n, small = 0.25, large = 1.0;
    center.insert(center.end(), {1.0, y, 2.0, 1.0 + small + large + gap[n], y, 2.0});
    radius.insert(radius.end(), {small, large});
    // The larger one comes first every other time.
    first.push_back(2 * n + n % 2);
    second.push_back(2 * n + 1 - n % 2);
  }
  std::vector<int> touching(gap.size() + 1, -1);
  const int found = find_touching_pairs(center.data(), radius.data(), first.data(), second.data(),
                                        gap.size(), touching.data());
  ASSERT_EQ(found, 3);
  EXPECT_EQ(std::vector<int>(touching.begin(), touching.begin() + 3), (std::vector<int>{0, 2, 4}));
}

TEST(TouchingPairs, FillABlock)
{
  const std::vector<double> center{0, 0, 0, 1.5, 0, 0}, radius{1.0, 1.0};
  const std::vector<int> first(longest_block, 0), second(longest_block, 1);
  std::vector<int> touching(longest_block);
  EXPECT_EQ(find_touching_pairs(center.data(), radius.data(), first.data(), second.data(),
                                longest_block, touching.data()),
            longest_block);
  EXPECT_EQ(touching.back(), longest_block - 1);
}
