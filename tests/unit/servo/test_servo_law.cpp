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
