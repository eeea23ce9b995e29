// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

using namespace encased_column;

namespace {

struct Spheres {
  std::vector<double> centers, radii;
  int size() const { return static_cast<int>(radii.size()); }
};

/// Spheres of 1 to 15 mm, as many of every size class, in a box in which they overlap here and
/// there.
Spheres random_spheres(int count, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Spheres spheres;
  for (int i = 0; i < count; ++i) {
    for (const double side : {0.05, 0.06, 0.1}) spheres.centers.push_back(side * part(random));
    spheres.radii.push_back(0.5e-3 * std::pow(15.0, part(random)));
  }
  return spheres;
}

using Pairs = std::set<std::pair<int, int>>;

/// By looking at all pairs.
Pairs pairs_near(const Spheres& spheres, double factor, double margin)
{
  Pairs pairs;
  for (int i = 0; i < spheres.size(); ++i)
    for (int j = i + 1; j < spheres.size(); ++j) {
      const double reach = factor * (spheres.radii[i] + spheres.radii[j]) + margin;
      const Vec3 apart = as_vec3(&spheres.centers[3 * i]) - as_vec3(&spheres.centers[3 * j]);
      if (apart.squaredNorm() <= reach * reach) pairs.emplace(i, j);
    }
  return pairs;
}

Pairs pairs_found(GrainGrid& grid, const Spheres& spheres, double factor, double margin)
{
  std::vector<double> wide;
  for (const double radius : spheres.radii) wide.push_back(factor * radius + 0.5 * margin);
  grid.sort(spheres.centers.data(), wide.data(), spheres.size());
  Pairs pairs;
  for (int i = 0; i < spheres.size(); ++i)
    grid.near(as_vec3(&spheres.centers[3 * i]), wide[i], i + 1, [&](int j) {
      EXPECT_TRUE(pairs.emplace(i, j).second) << "pair " << i << " " << j << " twice";
    });
  return pairs;
}

}  // namespace

TEST(GrainGrid, FindsEveryPairOnce)
{
  GrainGrid grid;  // one for all: what it keeps of the last spheres must not show
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Spheres spheres = random_spheres(50 * static_cast<int>(seed), seed);
    for (const double margin : {0.0, 0.2e-3, 5e-3})
      EXPECT_EQ(pairs_found(grid, spheres, 1.01, margin), pairs_near(spheres, 1.01, margin))
          << spheres.size() << " spheres, margin " << margin;
  }
}

TEST(GrainGrid, HasRoomForSpheresFarAway)
{
  Spheres spheres = random_spheres(300, 5);
  spheres.centers[0] = 1e6;
  spheres.centers[3] = -1e6;
  GrainGrid grid;
  EXPECT_EQ(pairs_found(grid, spheres, 1.0, 1e-3), pairs_near(spheres, 1.0, 1e-3));
}

TEST(GrainGrid, TakesNoSpheresOneAndAThousandfoldSizes)
{
  GrainGrid grid;
  EXPECT_TRUE(pairs_found(grid, {}, 1.0, 1e-3).empty());
  EXPECT_TRUE(pairs_found(grid, {{0.0, 0.0, 0.0}, {1e-3}}, 1.0, 1e-3).empty());
  const Spheres unequal{{0.0, 0.0, 0.0, 0.0, 0.0, 1.0005, 0.0, 0.0, 1.002}, {1.0, 1e-3, 1e-3}};
  EXPECT_EQ(pairs_found(grid, unequal, 1.0, 0.0), (Pairs{{0, 1}, {1, 2}}));
}

// A run that blows up must come to those who stop it with a reason.
TEST(GrainGrid, EndsWithAPositionThatIsNoNumber)
{
  Spheres spheres = random_spheres(50, 5);
  spheres.centers[3] = std::numeric_limits<double>::quiet_NaN();
  GrainGrid grid;
  grid.sort(spheres.centers.data(), spheres.radii.data(), spheres.size());
  spheres.centers[3] = std::numeric_limits<double>::infinity();
  grid.sort(spheres.centers.data(), spheres.radii.data(), spheres.size());
}
