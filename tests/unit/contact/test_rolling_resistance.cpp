// SPDX-License-Identifier: GPL-2.0-only
#include "contact/rolling_resistance.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const double shear_stiffness = 1e5, friction = 0.2, radius = 0.005, normal_force = 30.0;
const double limit = friction * normal_force * radius;
const Vec3 contact_normal(1.0, 0.0, 0.0);

double advance(const Vec3& spin, double dt, Vec3& torque)
{
  return advance_rolling_torque(shear_stiffness, friction, radius, normal_force, spin, Turn(),
                                contact_normal, dt, torque);
}

}  // namespace

TEST(RollingRadius, OfEqualGrainsIsHalfTheirRadius)
{
  EXPECT_DOUBLE_EQ(rolling_radius(0.01, 0.01), 0.005);
}

TEST(RollingRadius, AgainstAVeryLargeGrainIsThatOfTheSmallOne)
{
  EXPECT_NEAR(rolling_radius(0.01, 1e6), 0.01, 1e-9);
}

TEST(RollingTorque, IsStiffnessTimesAngleBelowTheLimit)
{
  Vec3 torque = Vec3::Zero();
  const double lost = advance({0.0, 2.0, 0.0}, 1e-3, torque);
  EXPECT_NEAR(torque.y(), shear_stiffness * radius * radius * 2e-3, 1e-15);
  EXPECT_EQ(lost, 0.0);
}

TEST(RollingTorque, StopsAtFrictionTimesNormalForceTimesRadius)
{
  Vec3 torque = Vec3::Zero();
  advance({0.0, 3.0, -4.0}, 10.0, torque);
  EXPECT_NEAR((torque - limit * Vec3(0.0, 0.6, -0.8)).norm(), 0.0, 1e-15);
}

TEST(RollingTorque, DoesNotResistTwist)
{
  Vec3 torque = Vec3::Zero();
  EXPECT_EQ(advance({5.0, 0.0, 0.0}, 1.0, torque), 0.0);
  EXPECT_EQ(torque.norm(), 0.0);
}

TEST(RollingTorque, TurnsTheWorkOfRollingIntoStoredAndLostEnergyToRoundOff)
{
  Vec3 torque = Vec3::Zero();
  double work = 0.0, lost = 0.0;
  const double dt = 1e-3;
  for (int step = 0; step < 400; ++step) {
    const Vec3 spin(0.0, std::cos(0.05 * step), 0.5);
    const Vec3 before = torque;
    lost += advance(spin, dt, torque);
    work += 0.5 * (before + torque).dot(spin) * dt;
  }
  const double stored = rolling_energy(shear_stiffness, radius, torque);
  EXPECT_GT(lost, stored);
  EXPECT_NEAR(work, stored + lost, 1e-12 * work);
}

TEST(RollingEnergy, IsHalfTorqueSquaredOverStiffness)
{
  EXPECT_DOUBLE_EQ(rolling_energy(1e5, 0.01, {0.0, 3.0, 4.0}), 0.5 * 25.0 / 10.0);
}
