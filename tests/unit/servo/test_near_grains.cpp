// SPDX-License-Identifier: GPL-2.0-only
#include "servo/near_grains.h"

#include "servo/wall_shape.h"

#include <gtest/gtest.h>

#include <map>

using namespace encased_column;

namespace {

const auto all = [](int) { return true; };

/// Grains of 10 mm radius, one each millimetre below a platen at 200 mm: number n is n mm away.
struct Column {
  PlaneShape top{0.2, 1.0};
  std::vector<double> centers, radii;

  explicit Column(int count) : radii(count, 0.01)
  {
    for (int n = 0; n < count; ++n) centers.insert(centers.end(), {0.0, 0.0, 0.2 - 1e-3 * n});
  }
};

}  // namespace

// Radius 10 mm and one and a half skins of 2 mm: centers less than 13 mm away.
TEST(NearGrains, AreThoseWithinRadiusAndOneAndAHalfSkins)
{
  const Column column(200);
  NearGrains near;
  near.list(column.top, 0.2, 2e-3, column.centers.data(), column.radii.data(), 200, all);
  EXPECT_EQ(near.numbers(), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  near.list(column.top, 0.2, 2e-3, column.centers.data(), column.radii.data(), 200,
            [](int i) { return i % 5 == 0; });
  EXPECT_EQ(near.numbers(), (std::vector<int>{0, 5, 10})) << "only those of the group";
}

// Whatever grains (half a skin before the list, half after) and wall (half a skin) do until a new
// list is made, none touches that was not near.
TEST(NearGrains, HoldAllThatCanTouchUntilTheyAreStale)
{
  const double skin = 2e-3, little = 1e-9;
  NearGrains near;
  Column column(30);
  near.list(column.top, 0.2, skin, column.centers.data(), column.radii.data(), 30, all);
  const double moved = 0.5 * skin - little;
  EXPECT_FALSE(near.is_stale(0.2 - moved, skin));
  EXPECT_FALSE(near.is_stale(0.2 + moved, skin));
  EXPECT_TRUE(near.is_stale(0.2 - moved - 2.0 * little, skin));
  column.top.advance(moved);
  for (int n = 0; n < 30; ++n)
    if (column.top.touches(&column.centers[3 * n], 0.01 + skin - little)) {
      EXPECT_EQ(near.numbers()[n], n);
    }
}

TEST(NearGrains, FindEveryTouchOnceWithOverlapAndNormal)
{
  Column column(200);  // many more than one batch of the search
  NearGrains near;
  near.list(column.top, 0.2, 1.0, column.centers.data(), column.radii.data(), 200, all);
  ASSERT_EQ(near.numbers().size(), 200u);
  column.radii.assign(200, 0.1505);
  std::map<int, double> found;
  near.find_touching(column.top, column.centers.data(), column.radii.data(),
                     [&](int n, double overlap, const Vec3& normal) {
                       EXPECT_TRUE(found.emplace(n, overlap).second) << "a second time";
                       EXPECT_EQ(normal, Vec3(0.0, 0.0, 1.0));
                     });
  EXPECT_EQ(found.size(), 151u);
  for (const auto& [n, overlap] : found) EXPECT_NEAR(overlap, 0.1505 - 1e-3 * n, 1e-12);
}

TEST(DistanceToWall, IsTheRadiusLessTheOverlapAndNeverNone)
{
  EXPECT_DOUBLE_EQ(distance_to_wall(0.01, 0.002), 0.008);
  EXPECT_DOUBLE_EQ(distance_to_wall(0.01, 0.02), 1e-5) << "its center is beyond the wall";
}
