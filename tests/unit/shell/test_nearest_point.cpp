// SPDX-License-Identifier: GPL-2.0-only
#include "shell/nearest_point.h"

#include "shell_cases.h"

#include <gtest/gtest.h>

#include <set>

using namespace encased_column;

namespace {

Vec3 point_of(const FacetVectors& corner, const Vec3& weight)
{
  return weight(0) * corner[0] + weight(1) * corner[1] + weight(2) * corner[2];
}

Vec3 nearest(const FacetVectors& corner, const Vec3& x)
{
  return nearest_on_triangle(corner[0], corner[1], corner[2], x);
}

/// Smallest distance [m] to the points of a grid of area coordinates.
double distance_to_grid(const FacetVectors& corner, const Vec3& x, int cells)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; i + j <= cells; ++j) {
      const Vec3 weight = Vec3(i, j, cells - i - j) / cells;
      smallest = std::min(smallest, (point_of(corner, weight) - x).norm());
    }
  return smallest;
}

}  // namespace

// Every point of the triangle lies within a cell of a grid point, so the true distance is at most
// the grid's and at least that less a cell.
TEST(NearestPoint, IsAsNearAsThePointsOfAFineGridInEveryRegionOfTheTriangle)
{
  RandomVectors random(3);
  const FacetVectors corner = skew_triangle();
  const int cells = 60;
  const double cell = (corner[1] - corner[0]).norm() / cells;
  std::set<int> regions;  // one bit for each area coordinate that is larger than zero
  for (int trial = 0; trial < 400; ++trial) {
    const Vec3 x = point_of(corner, Vec3::Constant(1.0 / 3.0)) + 1.5 * random();
    const Vec3 weight = nearest(corner, x);
    EXPECT_NEAR(weight.sum(), 1.0, 1e-14);
    EXPECT_GE(weight.minCoeff(), 0.0);
    EXPECT_LE(weight.maxCoeff(), 1.0);
    const double distance = (point_of(corner, weight) - x).norm();
    const double grid = distance_to_grid(corner, x, cells);
    EXPECT_LE(distance, grid + 1e-14);
    EXPECT_GE(distance, grid - cell);
    int region = 0;
    for (int i = 0; i < 3; ++i)
      if (weight(i) > 0.0) region |= 1 << i;
    regions.insert(region);
  }
  EXPECT_EQ(regions.size(), 7u) << "three corners, three sides, the inside";
}

TEST(NearestPoint, OfAPointOverTheInsideIsItsFoot)
{
  const FacetVectors corner = skew_triangle();
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const Vec3 share(0.2, 0.5, 0.3);
  for (const double height : {-2.0, 0.0, 0.3}) {
    const Vec3 weight = nearest(corner, point_of(corner, share) + height * normal);
    EXPECT_LT((weight - share).norm(), 1e-14) << "height " << height;
  }
}

TEST(NearestPoint, DoesNotDependOnWhichCornerComesFirst)
{
  RandomVectors random(4);
  const FacetVectors corner = skew_triangle();
  const FacetVectors turned{corner[1], corner[2], corner[0]};
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 x = 2.0 * random();
    EXPECT_LT((point_of(corner, nearest(corner, x)) - point_of(turned, nearest(turned, x))).norm(),
              1e-14);
  }
}
