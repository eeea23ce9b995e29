// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace encased_column;

TEST(CoincidentGrains, AreFoundWhereverTheyStand)
{
  std::vector<double> centers;
  for (int n = 0; n < 100; ++n)
    centers.insert(centers.end(), {std::sin(n), std::cos(3.0 * n), 0.1 * (n % 7)});
  EXPECT_FALSE(find_coincident(centers.data(), 100));
  for (int k = 0; k < 3; ++k) centers[3 * 90 + k] = centers[3 * 11 + k];
  const auto found = find_coincident(centers.data(), 100);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 11);
  EXPECT_EQ(found->second, 90);
}

TEST(CoincidentGrains, AreNotThoseThatShareTwoCoordinatesOrHaveNone)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> centers{0, 0, 0, 0, 0, 1, 0, 1, 0, none, 0, 0, none, 0, 0};
  EXPECT_FALSE(find_coincident(centers.data(), 5));
  EXPECT_FALSE(find_coincident(nullptr, 0));
}
