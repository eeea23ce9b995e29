// SPDX-License-Identifier: GPL-2.0-only
#include "shell/facet_grid.h"

#include "sleeve_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace encased_column;

namespace {

/// Distance [m] from `x` to the bounding sphere about the facet's center, below zero inside.
double distance_to_sphere(const ShellModel& model, int f, const Vec3& x)
{
  const FacetVectors corner = model.corners(f);
  const Vec3 center = (corner[0] + corner[1] + corner[2]) / 3.0;
  double radius = 0.0;
  for (const Vec3& c : corner) radius = std::max(radius, (c - center).norm());
  return (x - center).norm() - radius;
}

std::vector<int> near(const FacetGrid& grid, const Vec3& x, double reach)
{
  std::vector<int> found;
  grid.near(x, reach, [&](int f) { found.push_back(f); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST(FacetGrid, FindsOnceEveryFacetThatIsWithinReach)
{
  const ShellModel model = crumpled_tube(0.005);
  FacetGrid grid;
  grid.sort(model.facet(), model.position());
  RandomVectors random(6);
  std::size_t found_of_all = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 x = 0.08 * random() + Vec3(0.0, 0.0, 0.03);
    const double reach = 0.01 * (1.0 + random().x());
    const std::vector<int> found = near(grid, x, reach);
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "found twice";
    for (int f = 0; f < model.facets(); ++f) {
      if (distance_to_sphere(model, f, x) < reach) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), f)) << "facet " << f;
      }
    }
    for (const int f : found) EXPECT_LT(distance_to_sphere(model, f, x), reach + 1e-12);
    found_of_all += found.size();
  }
  EXPECT_LT(found_of_all, 2000u * model.facets() / 3) << "it spares most of the work";
}

TEST(FacetGrid, FindsNothingFarFromAllFacets)
{
  const ShellModel model = short_tube();
  FacetGrid grid;
  grid.sort(model.facet(), model.position());
  EXPECT_TRUE(near(grid, Vec3(0.3, 0.0, 0.0), 0.05).empty());
  EXPECT_TRUE(near(grid, Vec3(0.0, 0.0, -0.3), 0.05).empty());
}

TEST(FacetGrid, SortsASurfaceThatLiesInOnePlane)
{
  const std::vector<Vec3> node{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  FacetGrid grid;
  grid.sort({{0, 1, 2}, {0, 2, 3}}, node);
  EXPECT_EQ(near(grid, Vec3(0.5, 0.5, 0.2), 0.3), (std::vector<int>{0, 1}));
}

// A million grains apart, cubes of a facet's size would not fit in memory.
TEST(FacetGrid, SortsTwoSmallFacetsFarApart)
{
  const std::vector<Vec3> node{
      Vec3(0, 0, 0),          Vec3(0.01, 0, 0),          Vec3(0, 0.01, 0),
      Vec3(1000, 1000, 1000), Vec3(1000.01, 1000, 1000), Vec3(1000, 1000.01, 1000)};
  FacetGrid grid;
  grid.sort({{0, 1, 2}, {3, 4, 5}}, node);
  EXPECT_EQ(near(grid, node[4], 0.01), std::vector<int>{1});
  EXPECT_EQ(near(grid, node[0], 0.01), std::vector<int>{0});
}

// As many cubes as facets' sizes fit into their extent would be 1e12.
TEST(FacetGrid, OfSmallFacetsFarApartTakesLargerCubes)
{
  const double far = 1.0, small = 1e-6;
  std::vector<Vec3> node;
  std::vector<Facet> facet;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(far, 0, 0), Vec3(0, far, 0)}) {
    const int n = static_cast<int>(node.size());
    for (const Vec3& side : {Vec3(0, 0, 0), Vec3(small, 0, 0), Vec3(0, small, 0)})
      node.push_back(corner + side);
    facet.push_back({n, n + 1, n + 2});
  }
  FacetGrid grid;
  grid.sort(facet, node);
  EXPECT_EQ(near(grid, Vec3(far, 0, 0), 1e-3), std::vector<int>{1});
}
