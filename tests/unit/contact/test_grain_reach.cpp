// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

using namespace encased_column;

namespace {

constexpr double skin = 0.4e-3, largest = 7.5e-3;
const ReachRule rule{0.5 * skin, 2.0 * largest + skin, 1.0, 100.0};

/// Grains of 1 to 15 mm in a box in which they overlap here and there, most of them slow; now and
/// then one is pushed.
struct Grains {
  std::vector<double> center, velocity, radius, listed;
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
  ListedGrains view() const
  {
    return {center.data(), velocity.data(), radius.data(), size(), size()};
  }
  /// One step; returns a bound of the longest way.
  double move()
  {
    if (part(random) > 0.95) velocity[center.size() * 0.499 * (1.0 + part(random))] = 2e-5;
    double fastest = 0.0;
    for (std::size_t k = 0; k < center.size(); ++k) {
      center[k] += velocity[k];
      fastest = std::max(fastest, std::abs(velocity[k]));
      velocity[k] *= 0.99;
    }
    return std::sqrt(3.0) * fastest;
  }
  double gone(int i) const { return (as_vec3(&center[3 * i]) - as_vec3(&listed[3 * i])).norm(); }
  double gap(int i, int j) const
  {
    return (as_vec3(&center[3 * i]) - as_vec3(&center[3 * j])).norm() - radius[i] - radius[j];
  }
};

using Pairs = std::set<std::pair<int, int>>;

}  // namespace

TEST(GrainReach, IsHalfTheSkinOfTheHostWhereNothingElseIsSaid)
{
  EXPECT_EQ(GrainReach(skin)[0], 0.2e-3);
  EXPECT_DOUBLE_EQ(GrainReach(skin).margin(0), 1.5 * skin);
  EXPECT_FALSE(GrainReach(skin).is_wider());
}

TEST(GrainReach, IsWhatTheAccountSays)
{
  const double center[] = {0.0, 0.0, 0.0}, velocity[] = {0.0, 1e-5, 0.0}, radius[] = {1e-3};
  ReachAccount account;
  account.start({center, velocity, radius, 1, 1}, rule);
  EXPECT_DOUBLE_EQ(GrainReach(skin, &account)[0], 1e-3);
  EXPECT_DOUBLE_EQ(GrainReach(skin, &account).margin(0), 2e-3 + 0.5 * skin);
}

TEST(ReachRule, GivesFastGrainsWhatTheyGoInTheTimeAhead)
{
  EXPECT_EQ(rule.reach(1e-3, Vec3::Zero()), 0.5 * skin);
  EXPECT_EQ(rule.reach(1e-3, Vec3(1e-6, 0.0, 0.0)), 0.5 * skin);
  EXPECT_DOUBLE_EQ(rule.reach(1e-3, Vec3(0.0, 3e-6, 4e-6)), 5e-4);
}

TEST(ReachRule, GivesGrainsAtMeanSpeedTheLeast)
{
  ReachRule of_mean = rule;
  of_mean.horizon = reach_horizon(0.5 * skin, 4e-7);
  EXPECT_DOUBLE_EQ(of_mean.reach(1e-3, Vec3(4e-7, 0.0, 0.0)), 0.5 * skin);
  EXPECT_DOUBLE_EQ(of_mean.reach(1e-3, Vec3(8e-7, 0.0, 0.0)), skin);
  EXPECT_EQ(reach_horizon(0.5 * skin, 0.0), 0.0);
}

// The host brings ghosts from as far as two of the largest grains and the skin.
TEST(ReachRule, ListsNoPairFartherApartThanTheHostsGhosts)
{
  for (const double a : {0.5e-3, 2e-3, largest})
    for (const double b : {0.5e-3, 2e-3, largest})
      for (const double speed : {0.0, 1e-6, 1e-3}) {
        const Vec3 one(speed, 0.0, 0.0), other(1.0, 0.0, 0.0);
        const double most = 2.0 * largest + skin + 1e-12;
        EXPECT_LE(a + b + rule.reach(a, one) + rule.reach(b, other), most);
        EXPECT_LE(a + b + rule.wider_reach(a, one, 1.0) + rule.wider_reach(b, other, skin), most);
      }
  EXPECT_EQ(rule.reach(largest, Vec3(1e-3, 0.0, 0.0)), 0.5 * skin);
}

// What Comm::setup() and Comm::decide() of the host take as a ghost: a grain within half the
// cutoff, half the skin and its own radius of the border. One rank lies at x < 0, the other behind
// it.
TEST(ReachRule, LetsNoGrainTouchOneOfARankThatDoesNotKnowIt)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (const double beyond : {0.0, 2e-3}) {
    ReachRule here = rule;
    here.high.x() = 0.0;
    here.beyond = beyond;
    ReachRule there = rule;
    there.low.x() = 0.0;
    there.beyond = beyond;
    const double cutoff = rule.range + 2.0 * beyond;
    int wide = 0, touch = 0;
    for (int n = 0; n < 100000; ++n) {
      const double a = 0.5e-3 * std::pow(15.0, part(random)), b = n % 3 ? largest : a;
      const Vec3 one(-0.04 * part(random), 0.0, 0.0), other(0.02 * part(random), 0.0, 0.0);
      const double reach_of_one = here.known_beyond(rule.most(a), a, one),
                   reach_of_other = there.known_beyond(rule.most(b), b, other);
      EXPECT_GE(reach_of_one, std::min(rule.least, rule.most(a)));
      wide += reach_of_one > rule.least;
      if ((other - one).norm() > a + b + reach_of_one + reach_of_other) continue;
      ++touch;
      ASSERT_LE(-one.x(), 0.5 * cutoff + 0.5 * skin + a + 1e-12);
    }
    EXPECT_GT(wide, 1000);
    EXPECT_GT(touch, 1000);
  }
}

// Lists hand grains over to the next rank alone.
TEST(ReachRule, LetsNoGrainGoFartherThanTheThinnestRankIsWide)
{
  ReachRule thin = rule;
  thin.thinnest = 0.8e-3;
  const Vec3 fast(1.0, 0.0, 0.0);
  EXPECT_GT(rule.reach(1e-3, fast), thin.thinnest);
  EXPECT_EQ(thin.reach(1e-3, fast), thin.thinnest);
  EXPECT_EQ(thin.wider_reach(1e-3, fast, skin), thin.thinnest);
}

// The oracle looks at all pairs and all grains in every step.
TEST(ReachAccount, FindsAllThatTouchAndEveryGrainThatLeaves)
{
  Grains grains(150);
  ReachAccount account;
  int lists = 0, widened = 0;
  for (int step = 0; step < 3000; ++lists) {
    grains.listed = grains.center;
    account.start(grains.view(), rule);
    Pairs pairs;
    for (int i = 0; i < grains.size(); ++i)
      for (int j = i + 1; j < grains.size(); ++j)
        if (grains.gap(i, j) <= account.reach(i) + account.reach(j)) pairs.emplace(i, j);
    for (; step < 3000; ++step) {
      ReachAccount::Answer answer = ReachAccount::Answer::lists_hold;
      std::vector<double> before;
      for (int i = 0; i < grains.size(); ++i) before.push_back(account.reach(i));
      if (account.begin_step(grains.move()))
        answer = account.look(grains.view(), grains.listed.data());
      bool one_left = false;
      for (int i = 0; i < grains.size(); ++i) one_left |= grains.gone(i) > before[i];
      ASSERT_EQ(one_left, answer != ReachAccount::Answer::lists_hold) << "step " << step;
      if (answer == ReachAccount::Answer::lists_end) break;
      for (const int i : account.wider())
        for (int j = 0; j < grains.size(); ++j)
          if (j != i && grains.gap(i, j) <= 2.0 * (account.reach(i) + account.reach(j)))
            pairs.insert(std::minmax(i, j));
      widened += static_cast<int>(account.wider().size());
      for (int i = 0; i < grains.size(); ++i) {
        ASSERT_LE(grains.gone(i), account.reach(i));
        for (int j = i + 1; j < grains.size(); ++j)
          if (grains.gap(i, j) < 0.0) {
            ASSERT_TRUE(pairs.count({i, j})) << i << " and " << j << " at step " << step;
          }
      }
    }
  }
  EXPECT_GT(lists, 5);
  EXPECT_GT(widened, 2 * lists);
}

TEST(ReachAccount, EndsTheListsWhereMoreHaveLeftThanAreWorthLookingFor)
{
  constexpr int count = ReachAccount::most_wider + 1;
  const std::vector<double> start(3 * count, 0.0), still(3 * count, 0.0), radius(count, 1e-3);
  std::vector<double> center = start;
  ReachAccount account;
  account.start({center.data(), still.data(), radius.data(), count, count}, rule);
  const auto leave = [&](int i) {
    center[3 * i] = skin;
    EXPECT_TRUE(account.begin_step(skin));
    return account.look({center.data(), still.data(), radius.data(), count, count}, start.data());
  };
  for (int i = 0; i + 1 < count; ++i) {
    EXPECT_EQ(leave(i), ReachAccount::Answer::some_are_wider);
    EXPECT_EQ(account.wider(), std::vector<int>{i});
  }
  EXPECT_EQ(leave(count - 1), ReachAccount::Answer::lists_end);
}

TEST(ReachAccount, EndsTheListsWhereTheLargestGrainHasLeft)
{
  const double start[] = {0.0, 0.0, 0.0}, still[] = {0.0, 0.0, 0.0}, radius[] = {largest};
  const double center[] = {0.6 * skin, 0.0, 0.0};
  ReachAccount account;
  account.start({start, still, radius, 1, 1}, rule);
  EXPECT_TRUE(account.begin_step(0.6 * skin));
  EXPECT_EQ(account.look({center, still, radius, 1, 1}, start), ReachAccount::Answer::lists_end);
}

TEST(ReachAccount, TakesWhatAnotherRankSaysOfAGhost)
{
  const double center[] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, still[6] = {}, radius[] = {1e-3, 1e-3};
  ReachAccount account;
  account.start({center, still, radius, 1, 2}, rule);
  account.set_reach(1, 1e-3);  // as its rank listed it
  account.forget_wider();
  account.set_reach(1, 1e-3);
  EXPECT_TRUE(account.wider().empty());
  account.set_reach(1, 3e-3);
  EXPECT_EQ(account.wider(), std::vector<int>{1});
  EXPECT_EQ(account.reach(1), 3e-3);
  account.begin_step(0.0);
  EXPECT_TRUE(account.wider().empty());
}

TEST(ReachAccount, OfNoGrainsHasNoneThatLeave)
{
  ReachAccount account;
  account.start({}, rule);
  EXPECT_TRUE(account.begin_step(1.0));
  EXPECT_EQ(account.look({}, nullptr), ReachAccount::Answer::lists_hold);
}
