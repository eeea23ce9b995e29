// SPDX-License-Identifier: GPL-2.0-only
#include "servo/servo_law.h"

#include <gtest/gtest.h>

using namespace encased_column;

// A wall on springs of K: one step of the speed changes the force by K v dt.
TEST(ServoSpeed, ClosesTheGapByTheGainInOneStep)
{
  const double area = 0.02, dt = 1e-4, gain = 0.8, target = 1e5;
  for (const double start : {500.0, 3500.0}) {
    WallLoad load{start, 3e6};
    const double speed = servo_speed(load, target, area, gain, dt, 1e3);
    load.force += load.stiffness * speed * dt;
    EXPECT_NEAR(target * area - load.force, (1.0 - gain) * (target * area - start), 1e-9);
  }
}

TEST(ServoSpeed, StandsStillAtItsTarget)
{
  EXPECT_EQ(servo_speed({2000.0, 3e6}, 1e5, 0.02, 0.8, 1e-4, 1.0), 0.0);
}

TEST(ServoSpeed, IsCappedBothWays)
{
  EXPECT_EQ(servo_speed({0.0, 1.0}, 1e5, 0.02, 0.8, 1e-4, 0.5), 0.5);
  EXPECT_EQ(servo_speed({1e6, 1.0}, 1e5, 0.02, 0.8, 1e-4, 0.5), -0.5);
}

TEST(ServoSpeed, ApproachesAtItsLimitWithNothingInContact)
{
  EXPECT_EQ(servo_speed({0.0, 0.0}, 1e5, 0.02, 0.8, 1e-4, 0.5), 0.5);
}

TEST(ServoSpeed, WaitsWithNothingInContactAndNothingToReach)
{
  EXPECT_EQ(servo_speed({0.0, 0.0}, 0.0, 0.02, 0.8, 1e-4, 0.5), 0.0);
}

// Grains that give way at an even speed let the force of the plain law sag; with what it has learnt
// the servo meets its target.
TEST(SteadyServoSpeed, HoldsItsTargetOnGrainsThatGiveWay)
{
  const double area = 0.02, dt = 1.0, target = 1e5, yield = 2e-8;
  for (const double gain : {0.1, 0.8}) {
    WallLoad load{target * area, 3e9};
    ServoMemory memory;
    double speed = 0.0;
    for (int n = 0; n < 3000; ++n) {
      speed = steady_servo_speed(load, target, area, gain, dt, 1e-6, memory);
      load.force += load.stiffness * (speed - yield) * dt;
    }
    EXPECT_NEAR(load.force / area, target, 1e-6 * target) << "at gain " << gain;
    EXPECT_NEAR(speed, yield, 1e-6 * yield);
  }
}

TEST(SteadyServoSpeed, KeepsItsLimitAndLearnsNothingThere)
{
  ServoMemory memory{0.4};
  EXPECT_EQ(steady_servo_speed({0.0, 1.0}, 1e5, 0.02, 0.8, 1e-4, 0.5, memory), 0.5);
  EXPECT_EQ(memory.even_speed, 0.4);
}

TEST(SteadyServoSpeed, StartsAnewWithNothingInContact)
{
  ServoMemory memory{0.1};
  EXPECT_EQ(steady_servo_speed({0.0, 0.0}, 0.0, 0.02, 0.8, 1e-4, 0.5, memory), 0.0);
  EXPECT_EQ(memory.even_speed, 0.0);
}

TEST(UsualSpeedLimit, CrossesTheRadiusInAHundredThousandSteps)
{
  const double dt = 3e-6;
  EXPECT_NEAR(usual_speed_limit(0.05, dt) * dt * 1e5, 0.05, 1e-15);
}

// The force of a spring K goes linearly with the way: whatever the steps, the work is the energy
// the spring stores, K x^2 / 2.
TEST(WallWork, OnASpringIsTheEnergyItStores)
{
  const double stiffness = 3e6;
  WallWork work;
  double compression = 0.0;
  for (const double way : {1e-5, 4e-5, -2e-5, 0.0, 7e-5}) {
    work.begin_step(stiffness * compression, way);
    compression += way;
    work.end_step(stiffness * compression);
    EXPECT_NEAR(work.done(), 0.5 * stiffness * compression * compression, 1e-15);
  }
}

TEST(WallWork, GoesOnFromWhatARestartFileSays)
{
  WallWork work;
  work.restore(2.0);
  work.begin_step(10.0, 0.1);
  work.end_step(30.0);
  EXPECT_DOUBLE_EQ(work.done(), 4.0);
}
