// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_reach.h"

#include "contact/grain_grid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace encased_column;

namespace {

constexpr double skin = 0.4e-3, largest = 7.5e-3;
const ReachRule rule{0.5 * skin, 2.0 * largest + skin, 1.0, 300.0};

/// Grains of 1 to 15 mm in a box in which they overlap here and there, most of them slow.
struct Grains {
  std::vector<double> center, velocity, radius;
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> part{-1.0, 1.0};

  explicit Grains(int count)
  {
    for (int i = 0; i < count; ++i) {
      radius.push_back(0.5e-3 * std::pow(15.0, std::abs(part(random))));
      const double speed = 5e-6 * std::pow(std::abs(part(random)), 8.0);  // m per step
      for (int a = 0; a < 3; ++a) {
        center.push_back(0.03 * part(random));
        velocity.push_back(speed * part(random));
      }
    }
    radius[0] = largest;
  }
  int size() const { return static_cast<int>(radius.size()); }
  ListedGrains listed() const
  {
    return {center.data(), velocity.data(), radius.data(), size(), size()};
  }
  /// One step; returns a bound of the longest way.
  double move()
  {
    double fastest = 0.0;
    for (std::size_t k = 0; k < center.size(); ++k) {
      velocity[k] += 1e-7 * part(random);
      center[k] += velocity[k];
      fastest = std::max(fastest, std::abs(velocity[k]));
    }
    return std::sqrt(3.0) * fastest;
  }
};

using Pairs = std::set<std::pair<int, int>>;

Pairs touching(const Grains& grains)
{
  Pairs pairs;
  for (int i = 0; i < grains.size(); ++i)
    for (int j = i + 1; j < grains.size(); ++j)
      if ((as_vec3(&grains.center[3 * i]) - as_vec3(&grains.center[3 * j])).norm() <
          grains.radius[i] + grains.radius[j])
        pairs.emplace(i, j);
  return pairs;
}

Pairs listed_pairs(const Grains& grains, const std::vector<double>& reach)
{
  std::vector<double> wide = grains.radius;
  for (int i = 0; i < grains.size(); ++i) wide[i] += reach[i];
  GrainGrid grid;
  grid.sort(grains.center.data(), wide.data(), grains.size());
  Pairs pairs;
  for (int i = 0; i < grains.size(); ++i)
    grid.near(as_vec3(&grains.center[3 * i]), wide[i], i + 1, [&](int j) { pairs.emplace(i, j); });
  return pairs;
}

}  // namespace

TEST(GrainReach, IsHalfTheSkinOfTheHostWhereNothingElseIsSaid)
{
  const double own[] = {1e-3};
  EXPECT_EQ(GrainReach(skin)[0], 0.2e-3);
  EXPECT_EQ(GrainReach(skin, own)[0], 1e-3);
  EXPECT_DOUBLE_EQ(GrainReach(skin).margin(0), 1.5 * skin);
  EXPECT_DOUBLE_EQ(GrainReach(skin, own).margin(0), 2e-3 + 0.5 * skin);
}

TEST(ReachRule, GivesFastGrainsWhatTheyGoInTheTimeAhead)
{
  EXPECT_EQ(rule.reach(1e-3, 0.0), 0.5 * skin);
  EXPECT_DOUBLE_EQ(rule.reach(1e-3, 2e-6), 0.5 * skin + 300.0 * 2e-6);
}

// The host brings ghosts from as far as two of the largest grains and the skin.
TEST(ReachRule, ListsNoPairFartherApartThanTheHostsGhosts)
{
  for (const double a : {0.5e-3, 2e-3, largest})
    for (const double b : {0.5e-3, 2e-3, largest})
      for (const double speed : {0.0, 1e-6, 1e-3})
        EXPECT_LE(a + b + rule.reach(a, speed) + rule.reach(b, 1.0), 2.0 * largest + skin + 1e-12);
  EXPECT_EQ(rule.reach(largest, 1e-3), 0.5 * skin);
}

// As long as no grain has left its reach, and at the step at which one has, no later.
TEST(ListedPlaces, KnowTheFirstStepAtWhichAGrainLeavesItsReach)
{
  Grains grains(500);
  ListedPlaces places;
  int lists = 0;
  for (int step = 0; step < 4000; ++lists) {
    const std::vector<double> start = grains.center;
    places.start(grains.listed(), rule);
    const std::vector<double> reach = places.reach();
    bool one_is_out = false;
    for (; !one_is_out && step < 4000; ++step) {
      const double way = grains.move();
      for (int i = 0; i < grains.size(); ++i)
        if ((as_vec3(&grains.center[3 * i]) - as_vec3(&start[3 * i])).norm() > reach[i])
          one_is_out = true;
      ASSERT_EQ(places.is_left(grains.center.data(), way), one_is_out) << "step " << step;
    }
  }
  EXPECT_GT(lists, 5);
}

TEST(ListedPlaces, FindAllThatTouchUntilAGrainLeavesItsReach)
{
  Grains grains(500);
  ListedPlaces places;
  for (int list = 0; list < 5; ++list) {
    places.start(grains.listed(), rule);
    const Pairs listed = listed_pairs(grains, places.reach());
    std::vector<double> before;
    double way = 0.0;
    do {
      before = grains.center;
      way = grains.move();
    } while (!places.is_left(grains.center.data(), way));
    grains.center.swap(before);
    for (const auto& pair : touching(grains)) EXPECT_TRUE(listed.count(pair));
    grains.center.swap(before);
  }
}

TEST(ListedPlaces, OfNoGrainsAreNeverLeft)
{
  ListedPlaces places;
  places.start({nullptr, nullptr, nullptr, 0, 0}, rule);
  EXPECT_FALSE(places.is_left(nullptr, 1.0));
}
