// SPDX-License-Identifier: GPL-2.0-only
#include "servo/wall_motion.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const KeywordTable table{WallMotion::keywords(), {}};

/// The motion after the deck's `words`, at step 100 and a stress of 20 Pa.
void read(WallMotion& motion, const std::vector<std::string>& words)
{
  motion.read(table.read(words), 100, 20.0);
}

/// First speed of a wall of 1 m^2 on 1 N/m, without load, steps of 1 s: gain times target.
double speed_at(WallMotion motion, long step)
{
  return motion.speed(step, 1.0, {0.0, 1.0}, 1.0, 1e9);
}

void expect_refused(const std::vector<std::string>& words, const std::string& sentence)
{
  WallMotion motion;
  try {
    read(motion, words);
    FAIL() << "not refused: " << sentence;
  } catch (const InputError& problem) {
    EXPECT_EQ(problem.what(), sentence);
  }
}

}  // namespace

TEST(WallMotion, StandsStillUnlessTold)
{
  EXPECT_EQ(speed_at(WallMotion(), 100), 0.0);
}

TEST(WallMotion, GoesAtTheSpeedGivenWhateverTheLoad)
{
  WallMotion motion;
  read(motion, {"velocity", "-2e-3"});
  EXPECT_EQ(motion.speed(100, 1.0, {1e9, 1.0}, 1.0, 1e-6), -2e-3);
}

TEST(WallMotion, FollowsAStressAtOnceWithoutRamp)
{
  WallMotion motion;
  read(motion, {"servo", "50", "gain", "0.5"});
  EXPECT_DOUBLE_EQ(speed_at(motion, 100), 25.0);
}

TEST(WallMotion, RampsLinearlyFromTheStressOfTheStepItWasTold)
{
  WallMotion motion;
  read(motion, {"servo", "50", "ramp", "10", "gain", "0.5"});
  EXPECT_DOUBLE_EQ(speed_at(motion, 100), 0.5 * 20.0);
  EXPECT_DOUBLE_EQ(speed_at(motion, 105), 0.5 * 35.0);
  EXPECT_DOUBLE_EQ(speed_at(motion, 110), 0.5 * 50.0);
  EXPECT_DOUBLE_EQ(speed_at(motion, 1000), 0.5 * 50.0);
}

TEST(WallMotion, CountsTheStepsUntilItsRampEnds)
{
  WallMotion motion;
  EXPECT_EQ(motion.ramp_left(100), 0);
  read(motion, {"servo", "50", "ramp", "10"});
  EXPECT_EQ(motion.ramp_left(100), 10);
  EXPECT_EQ(motion.ramp_left(104), 6);
  EXPECT_EQ(motion.ramp_left(1000), 0);
  read(motion, {"velocity", "1"});
  EXPECT_EQ(motion.ramp_left(100), 0);
}

TEST(WallMotion, KeepsToItsOwnSpeedLimitBeforeTheUsualOne)
{
  WallMotion motion;
  read(motion, {"servo", "50"});
  EXPECT_EQ(motion.speed(100, 1.0, {0.0, 1.0}, 1.0, 3.0), 3.0);
  read(motion, {"servo", "50", "speed_limit", "2"});
  EXPECT_EQ(motion.speed(100, 1.0, {0.0, 1.0}, 1.0, 3.0), 2.0);
}

TEST(WallMotion, KeepsItsGainWhenOnlyTheTargetChanges)
{
  WallMotion motion;
  read(motion, {"servo", "50", "gain", "0.1"});
  read(motion, {"servo", "100"});
  EXPECT_DOUBLE_EQ(speed_at(motion, 100), 10.0);
}

TEST(WallMotion, IsOutOfReachAfterItsPatienceAtTheSpeedLimit)
{
  for (const double force : {0.0, 1e9}) {  // too little: towards the specimen; too much: away
    WallMotion motion;
    read(motion, {"servo", "50", "patience", "3"});
    for (long n = 0; n < 3; ++n) motion.speed(100 + n, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_FALSE(motion.is_out_of_reach());
    motion.speed(103, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_TRUE(motion.is_out_of_reach());
  }
}

TEST(WallMotion, CountsItsPatienceInOneDirectionAndWithoutABreak)
{
  WallMotion motion;
  read(motion, {"servo", "50", "patience", "3"});
  for (const double force : {0.0, 0.0, 50.0, 0.0, 0.0, 1e9, 1e9, 0.0, 0.0, 0.0}) {
    motion.speed(100, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_FALSE(motion.is_out_of_reach());
  }
  motion.speed(100, 1.0, {0.0, 1.0}, 1.0, 1e-6);
  EXPECT_TRUE(motion.is_out_of_reach());
  read(motion, {"servo", "60"});
  EXPECT_FALSE(motion.is_out_of_reach()) << "a new target starts the count again";
}

TEST(WallMotion, RefusesWhatContradictsItself)
{
  expect_refused(
      {"hold", "servo", "50"},
      "a wall does one of 'hold', 'velocity' and 'servo', found more than one, write one "
      "of them");
  expect_refused({"velocity", "1", "ramp", "10"},
                 "'ramp' goes with 'servo', found it alone, write 'servo STRESS ramp STEPS'");
}

TEST(WallMotion, RefusesNumbersOutOfRange)
{
  expect_refused({"servo", "-1"},
                 "'servo' must be zero or larger, found -1, write for example 'servo 1'");
  expect_refused({"servo", "1", "gain", "0.9"},
                 "'gain' must be between 0.001 and 0.8, found 0.9, write for example 'gain 0.4'");
  expect_refused({"servo", "1", "ramp", "0"},
                 "'ramp' must be 1 or larger, found 0, write for example 'ramp 1'");
}

TEST(WallMotion, GoesOnAfterARestartAsIfThereWasNone)
{
  WallMotion motion;
  read(motion, {"servo", "50", "ramp", "10", "gain", "0.5", "speed_limit", "30", "patience", "7"});
  for (long n = 0; n < 5; ++n) motion.speed(100 + n, 1.0, {1.0, 1.0}, 1.0, 1e9);
  WallMotion restored;
  restored.restore(motion.state());
  EXPECT_EQ(restored.patience(), 7);
  EXPECT_EQ(restored.ramp_left(105), 5);
  for (long step = 105; step < 120; ++step) {
    const WallLoad load{step < 112 ? 1.0 : -1e6, 1.0};  // then at the speed limit
    EXPECT_EQ(restored.speed(step, 1.0, load, 1.0, 1e9), motion.speed(step, 1.0, load, 1.0, 1e9));
    EXPECT_EQ(restored.is_out_of_reach(), motion.is_out_of_reach()) << "at step " << step;
  }
  EXPECT_TRUE(restored.is_out_of_reach());
}
