// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/kick_grains.h"
#include "dynamics/local_damping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace encased_column;

namespace {

/// Grains of many sizes with forces and speeds of either sign, some of them zero.
struct Grains {
  explicit Grains(int count)
      : velocity(3 * count),
        spin(3 * count),
        force(3 * count),
        moment(3 * count),
        radius(count),
        mass(count)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (auto* row : {&velocity, &spin, &force, &moment})
      for (double& component : *row) {
        component = number(random);
        if (component > 0.9) component = 0.0;
      }
    for (double& r : radius) r = 1e-3 * (2.0 + number(random));
    for (double& m : mass) m = 1e-3 * (2.0 + number(random));
  }
  GrainBatch row()
  {
    return {velocity.data(),
            spin.data(),
            force.data(),
            moment.data(),
            radius.data(),
            mass.data(),
            static_cast<int>(radius.size())};
  }
  std::vector<double> velocity, spin, force, moment, radius, mass;
};

}  // namespace

TEST(KickGrains, DoesWhatHalfAKickDoesToEveryGrain)
{
  const double alpha = 0.7, half_step = 2e-9;
  for (int count = 1; count <= largest_batch; ++count) {
    Grains together(count), one_by_one(count);
    double loss = 0.0, fastest = 0.0;
    for (int i = 0; i < count; ++i) {
      const double m = one_by_one.mass[i], inertia = 0.4 * m * std::pow(one_by_one.radius[i], 2);
      loss += kick(&one_by_one.force[3 * i], alpha, half_step / m, half_step,
                   &one_by_one.velocity[3 * i]);
      loss += kick(&one_by_one.moment[3 * i], alpha, half_step / inertia, half_step,
                   &one_by_one.spin[3 * i]);
    }
    const BatchKick kick = kick_grains(together.row(), alpha, half_step);
    for (int k = 0; k < 3 * count; ++k) {
      EXPECT_NEAR(together.velocity[k], one_by_one.velocity[k], 1e-15) << count;
      EXPECT_NEAR(together.spin[k], one_by_one.spin[k], 1e-13 * (1 + std::abs(one_by_one.spin[k])));
      fastest = std::max(fastest, one_by_one.velocity[k] * one_by_one.velocity[k]);
    }
    EXPECT_NEAR(kick.loss, loss, 1e-13 * std::abs(loss)) << count;
    EXPECT_NEAR(kick.fastest, fastest, 1e-14) << count;
  }
}

// The work of the force that acts is the gain in kinetic energy; what damping took is the rest.
TEST(KickGrains, LossIsTheWorkOfTheForcesLessTheGainInEnergy)
{
  Grains grains(50);
  const Grains before = grains;
  const double half_step = 1e-4;
  const double loss = kick_grains(grains.row(), 0.5, half_step).loss;
  double work = 0.0, gain = 0.0;
  for (int k = 0; k < 150; ++k) {
    const double m = before.mass[k / 3], inertia = 0.4 * m * std::pow(before.radius[k / 3], 2);
    work += 0.5 * half_step *
            (before.force[k] * (before.velocity[k] + grains.velocity[k]) +
             before.moment[k] * (before.spin[k] + grains.spin[k]));
    gain += 0.5 * m * (std::pow(grains.velocity[k], 2) - std::pow(before.velocity[k], 2)) +
            0.5 * inertia * (std::pow(grains.spin[k], 2) - std::pow(before.spin[k], 2));
  }
  EXPECT_NEAR(loss, work - gain, 1e-10 * std::abs(loss));
}

TEST(KickGrains, TwiceIsTwoKicksToTheLastBit)
{
  for (const int count : {1, 7, 50, largest_batch}) {
    Grains together(count), in_turn(count);
    const TwoKicks kicks = kick_grains_twice(together.row(), 0.7, 1e-4);
    const BatchKick last = kick_grains(in_turn.row(), 0.7, 1e-4);
    const BatchKick first = kick_grains(in_turn.row(), 0.7, 1e-4);
    EXPECT_EQ(together.velocity, in_turn.velocity);
    EXPECT_EQ(together.spin, in_turn.spin);
    EXPECT_NEAR(kicks.loss_of_last, last.loss, 1e-14 * std::abs(last.loss));
    EXPECT_NEAR(kicks.first.loss, first.loss, 1e-14 * std::abs(first.loss));
    EXPECT_EQ(kicks.first.fastest, first.fastest);
  }
}
