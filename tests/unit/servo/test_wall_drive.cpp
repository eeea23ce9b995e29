#include "servo/wall_drive.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const KeywordTable table{WallDrive::keywords(), {}};

/// The drive after the deck's `words`, at step 100 and a stress of 20 Pa.
void read(WallDrive& drive, const std::vector<std::string>& words)
{
  drive.read(table.read(words), 100, 20.0);
}

/// First speed of a wall of 1 m^2 on 1 N/m, without load, steps of 1 s: gain times target.
double speed_at(WallDrive drive, long step)
{
  return drive.speed(step, 1.0, {0.0, 1.0}, 1.0, 1e9);
}

void expect_refused(const std::vector<std::string>& words, const std::string& sentence)
{
  WallDrive drive;
  try {
    read(drive, words);
    FAIL() << "not refused: " << sentence;
  } catch (const InputError& problem) {
    EXPECT_EQ(problem.what(), sentence);
  }
}

}  // namespace

TEST(WallDrive, StandsStillUnlessTold)
{
  EXPECT_EQ(speed_at(WallDrive(), 100), 0.0);
}

TEST(WallDrive, GoesAtTheSpeedGivenWhateverTheLoad)
{
  WallDrive drive;
  read(drive, {"velocity", "-2e-3"});
  EXPECT_EQ(drive.speed(100, 1.0, {1e9, 1.0}, 1.0, 1e-6), -2e-3);
}

TEST(WallDrive, FollowsAStressAtOnceWithoutRamp)
{
  WallDrive drive;
  read(drive, {"servo", "50", "gain", "0.5"});
  EXPECT_DOUBLE_EQ(speed_at(drive, 100), 25.0);
}

TEST(WallDrive, RampsLinearlyFromTheStressOfTheStepItWasTold)
{
  WallDrive drive;
  read(drive, {"servo", "50", "ramp", "10", "gain", "0.5"});
  EXPECT_DOUBLE_EQ(speed_at(drive, 100), 0.5 * 20.0);
  EXPECT_DOUBLE_EQ(speed_at(drive, 105), 0.5 * 35.0);
  EXPECT_DOUBLE_EQ(speed_at(drive, 110), 0.5 * 50.0);
  EXPECT_DOUBLE_EQ(speed_at(drive, 1000), 0.5 * 50.0);
}

TEST(WallDrive, CountsTheStepsUntilItsRampEnds)
{
  WallDrive drive;
  EXPECT_EQ(drive.ramp_left(100), 0);
  read(drive, {"servo", "50", "ramp", "10"});
  EXPECT_EQ(drive.ramp_left(100), 10);
  EXPECT_EQ(drive.ramp_left(104), 6);
  EXPECT_EQ(drive.ramp_left(1000), 0);
  read(drive, {"velocity", "1"});
  EXPECT_EQ(drive.ramp_left(100), 0);
}

TEST(WallDrive, KeepsToItsOwnSpeedLimitBeforeTheUsualOne)
{
  WallDrive drive;
  read(drive, {"servo", "50"});
  EXPECT_EQ(drive.speed(100, 1.0, {0.0, 1.0}, 1.0, 3.0), 3.0);
  read(drive, {"servo", "50", "speed_limit", "2"});
  EXPECT_EQ(drive.speed(100, 1.0, {0.0, 1.0}, 1.0, 3.0), 2.0);
}

TEST(WallDrive, KeepsItsGainWhenOnlyTheTargetChanges)
{
  WallDrive drive;
  read(drive, {"servo", "50", "gain", "0.1"});
  read(drive, {"servo", "100"});
  EXPECT_DOUBLE_EQ(speed_at(drive, 100), 10.0);
}

TEST(WallDrive, IsOutOfReachAfterItsPatienceAtTheSpeedLimit)
{
  for (const double force : {0.0, 1e9}) {  // too little: towards the specimen; too much: away
    WallDrive drive;
    read(drive, {"servo", "50", "patience", "3"});
    for (long n = 0; n < 3; ++n) drive.speed(100 + n, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_FALSE(drive.is_out_of_reach());
    drive.speed(103, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_TRUE(drive.is_out_of_reach());
  }
}

TEST(WallDrive, CountsItsPatienceInOneDirectionAndWithoutABreak)
{
  WallDrive drive;
  read(drive, {"servo", "50", "patience", "3"});
  for (const double force : {0.0, 0.0, 50.0, 0.0, 0.0, 1e9, 1e9, 0.0, 0.0, 0.0}) {
    drive.speed(100, 1.0, {force, 1.0}, 1.0, 1e-6);
    EXPECT_FALSE(drive.is_out_of_reach());
  }
  drive.speed(100, 1.0, {0.0, 1.0}, 1.0, 1e-6);
  EXPECT_TRUE(drive.is_out_of_reach());
  read(drive, {"servo", "60"});
  EXPECT_FALSE(drive.is_out_of_reach()) << "a new target starts anew";
}

TEST(WallDrive, RefusesWhatContradictsItself)
{
  expect_refused(
      {"hold", "servo", "50"},
      "a wall does one of 'hold', 'velocity' and 'servo', found more than one, write one "
      "of them");
  expect_refused({"velocity", "1", "ramp", "10"},
                 "'ramp' goes with 'servo', found it alone, write 'servo STRESS ramp STEPS'");
}

TEST(WallDrive, RefusesNumbersOutOfRange)
{
  expect_refused({"servo", "-1"},
                 "'servo' must be zero or larger, found -1, write for example 'servo 1'");
  expect_refused({"servo", "1", "gain", "0.9"},
                 "'gain' must be between 0.001 and 0.8, found 0.9, write for example 'gain 0.4'");
  expect_refused({"servo", "1", "ramp", "0"},
                 "'ramp' must be 1 or larger, found 0, write for example 'ramp 1'");
}
