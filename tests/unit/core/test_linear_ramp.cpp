// SPDX-License-Identifier: GPL-2.0-only
#include "core/linear_ramp.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(LinearRamp, RisesEvenlyAndThenStays)
{
  for (const auto division :
       {LinearRamp::Division::of_the_way_gone, LinearRamp::Division::of_the_steps_gone}) {
    LinearRamp ramp(0.0, division);
    EXPECT_EQ(ramp.at(5), 0.0);
    ramp.set(10e3, 200, 100);
    EXPECT_DOUBLE_EQ(ramp.at(100), 0.0);
    EXPECT_DOUBLE_EQ(ramp.at(150), 2.5e3);
    EXPECT_DOUBLE_EQ(ramp.at(300), 10e3);
    EXPECT_DOUBLE_EQ(ramp.at(5000), 10e3);
    ramp.set(0.0, 100, 350);
    EXPECT_DOUBLE_EQ(ramp.at(400), 5e3);
  }
}

TEST(LinearRamp, SetOnItsWayGoesOnFromWhereItIs)
{
  LinearRamp ramp(100.0);
  ramp.set(200.0, 10, 0);
  ramp.set(0.0, 30, 5);
  EXPECT_DOUBLE_EQ(ramp.at(5), 150.0);
  EXPECT_DOUBLE_EQ(ramp.at(15), 100.0);
  EXPECT_DOUBLE_EQ(ramp.at(35), 0.0);
}

TEST(LinearRamp, StartsFromAMeasuredValueInsteadOfItsOwn)
{
  LinearRamp ramp(100.0);
  ramp.start_from(20.0, 50.0, 10, 7);
  EXPECT_DOUBLE_EQ(ramp.at(7), 20.0);
  EXPECT_DOUBLE_EQ(ramp.at(12), 35.0);
  EXPECT_EQ(ramp.target(), 50.0);
}

TEST(LinearRamp, WithoutStepsIsThereAtOnce)
{
  LinearRamp ramp(1.0);
  ramp.set(2.0, 0, 10);
  EXPECT_EQ(ramp.at(10), 2.0);
  EXPECT_EQ(ramp.steps_left(10), 0);
}

TEST(LinearRamp, CountsTheStepsUntilItsTarget)
{
  LinearRamp ramp;
  EXPECT_EQ(ramp.steps_left(3), 0);
  ramp.set(50.0, 10, 100);
  EXPECT_EQ(ramp.steps_left(100), 10);
  EXPECT_EQ(ramp.steps_left(104), 6);
  EXPECT_EQ(ramp.steps_left(1000), 0);
}

TEST(LinearRamp, GoesOnAfterARestartAsIfThereWasNone)
{
  LinearRamp ramp(3.0), restored;
  ramp.set(50.0, 10, 1000000000000);
  restored.restore(ramp.state());
  for (const long step : {1000000000000, 1000000000003, 1000000000010, 2000000000000}) {
    EXPECT_EQ(restored.at(step), ramp.at(step));
    EXPECT_EQ(restored.steps_left(step), ramp.steps_left(step));
  }
}
