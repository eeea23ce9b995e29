// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/local_damping.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(LocalDamping, TakesItsPartFromAForceThatDrives)
{
  EXPECT_DOUBLE_EQ(damped(10.0, 2.0, 0.7), 3.0);
  EXPECT_DOUBLE_EQ(damped(-10.0, -2.0, 0.7), -3.0);
}

TEST(LocalDamping, AddsItsPartToAForceThatBrakes)
{
  EXPECT_DOUBLE_EQ(damped(10.0, -2.0, 0.7), 17.0);
  EXPECT_DOUBLE_EQ(damped(-10.0, 2.0, 0.7), -17.0);
}

TEST(LocalDamping, LeavesSteadyMotionAndABodyAtRestAlone)
{
  EXPECT_EQ(damped(0.0, 2.0, 0.7), 0.0);
  EXPECT_EQ(damped(10.0, 0.0, 0.7), 10.0);
}

// Work of the force is kinetic energy plus loss, whatever the step and the signs.
TEST(Kick, AccountsForTheWorkOfTheForceToRoundOff)
{
  const double mass = 0.3, half_step = 0.01;
  for (const double before : {2.0, -2.0, 0.0, 1e-3}) {
    const double force[3] = {5.0, -5.0, 0.0};
    double velocity[3] = {before, before, before};
    const double loss = kick(force, 0.7, half_step / mass, half_step, velocity);
    double work = 0.0, kinetic = 0.0;
    for (int a = 0; a < 3; ++a) {
      work += force[a] * 0.5 * (before + velocity[a]) * half_step;
      kinetic += 0.5 * mass * (velocity[a] * velocity[a] - before * before);
    }
    EXPECT_NEAR(work, kinetic + loss, 1e-15) << before << " m/s";
  }
}

// Released at rest at x0, a mass on a spring feels (1 - alpha) k x on its way to the middle and
// (1 + alpha) k x beyond: (1 - alpha) x0^2 = (1 + alpha) x1^2.
TEST(Kick, ShrinksTheSwingOfASpringAsItsEnergyBalanceSays)
{
  for (const double alpha : {0.2, 0.7}) {
    const double mass = 2.0, stiffness = 50.0, dt = 1e-4 * std::sqrt(mass / stiffness);
    double x = 1.0, v[3] = {0.0, 0.0, 0.0};
    const auto half_kick = [&] {
      const double force[3] = {-stiffness * x, 0.0, 0.0};
      kick(force, alpha, 0.5 * dt / mass, 0.5 * dt, v);
    };
    do {
      half_kick();
      x += dt * v[0];
      half_kick();
    } while (v[0] < 0.0);
    EXPECT_NEAR(x * x, (1.0 - alpha) / (1.0 + alpha), 1e-3) << "at alpha = " << alpha;
  }
}
