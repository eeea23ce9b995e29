// SPDX-License-Identifier: GPL-2.0-only
#include "bag_of_grains.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

using namespace encased_column;

namespace {

/// Energy [J] at a step: stored plus kinetic, the latter mixed from the velocities before and after
/// as in test_free_sleeve.cpp, plus what friction took.
std::array<double, 10> mean_energies(BagOfGrains& bag, int steps)
{
  std::array<double, 10> mean{};
  for (int i = 0; i < steps; ++i) mean[i * 10L / steps] += bag.step() * 10.0 / steps;
  return mean;
}

}  // namespace

TEST(BagOfGrains, KeepsLinearAndAngularMomentumToRoundOffOver100000Steps)
{
  BagOfGrains bag({1e6, 2.0, 0.5, 0.0, 0.0, 0.2});
  const Vec3 linear = bag.linear_momentum(), angular = bag.angular_momentum();
  const double size = bag.momentum_size();
  for (int i = 0; i < 100000; ++i) bag.step();
  std::printf("bag of grains: momentum off by %.1e of sum m v, angular by %.1e of 0.05 m sum m v\n",
              (bag.linear_momentum() - linear).norm() / size,
              (bag.angular_momentum() - angular).norm() / (0.05 * size));
  EXPECT_GT(bag.sleeve_contacts(), 1000);
  EXPECT_LT((bag.linear_momentum() - linear).norm(), 1e-11 * size);
  EXPECT_LT((bag.angular_momentum() - angular).norm(), 1e-10 * 0.05 * size);
}

TEST(BagOfGrains, GainsNoEnergyOver100000StepsWithoutFriction)
{
  BagOfGrains bag({1e6, 2.0, 0.0, 0.0, 0.0, 0.0});
  const auto mean = mean_energies(bag, 100000);
  std::printf(
      "bag without friction: energy of the last 10000 of 100000 steps over the first %.5f\n",
      mean[9] / mean[0]);
  for (const double m : mean) EXPECT_NEAR(m / mean[0], 1.0, 0.005);
}

TEST(BagOfGrains, ClosesItsAccountOver100000StepsWithFriction)
{
  BagOfGrains bag({1e6, 2.0, 0.5, 0.0, 0.0, 0.0});
  const auto mean = mean_energies(bag, 100000);
  std::printf(
      "bag with friction: energy and losses of the last 10000 steps over the first %.5f, "
      "losses %.3f\n",
      mean[9] / mean[0], bag.losses() / mean[0]);
  for (const double m : mean) EXPECT_NEAR(m / mean[0], 1.0, 0.02);
}
