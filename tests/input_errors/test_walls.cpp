// SPDX-License-Identifier: GPL-2.0-only
#include "input_errors/refusal.h"

using namespace encased_column::testing;

TEST(Platen, RefusesTwoWaysToMove)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 2 servo 50e3 velocity 0.01
run 1
)",
                 "a wall does one of 'hold', 'velocity' and 'servo', found more than one, write "
                 "one of them");
}

TEST(Platen, RefusesTwoWaysToMoveLaterToo)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 2
fix_modify top hold servo 50e3
run 1
)",
                 "a wall does one of 'hold', 'velocity' and 'servo', found more than one, write "
                 "one of them");
}

TEST(Platen, RefusesToBePutElsewhereLater)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 2
fix_modify top z 0.09
run 1
)",
                 "unknown keyword 'z', expected one of: type, hold, velocity, servo, ramp, gain, "
                 "speed_limit, patience");
}

TEST(Platen, RefusesARampWithoutAServo)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 2 ramp 100
run 1
)",
                 "'ramp' goes with 'servo', found it alone, write 'servo STRESS ramp STEPS'");
}

TEST(Platen, RefusesBothSideAndArea)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 side side area 0.0016 type 2
run 1
)",
                 "a platen takes one of 'side' and 'area', found both, write 'side ID' or 'area "
                 "0.00785'");
}

TEST(Platen, RefusesATypeTheBoxDoesNotHave)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 3
run 1
)",
                 "'type' must be one of the 2 atom types, found 3, write a smaller one or make "
                 "room in 'create_box'");
}

TEST(Platen, RefusesToStandWithoutAHeight)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top area 0.0016 type 2
run 1
)",
                 "keyword 'z' is missing, add 'z ...'");
}

TEST(Platen, RefusesAPatienceOfNoStep)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 area 0.0016 type 2 servo 50e3 patience 0
run 1
)",
                 "'patience' must be 1 or larger, found 0, write for example 'patience 1'");
}

TEST(Platen, StopsTheRunWhenItsStressIsOutOfReach)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.5 area 0.0016 type 2 servo 50e3 patience 100
run 200
)",
                 "'servo' must be a stress that the grains can bear, found 0 of 50000 Pa after 100 "
                 "steps at the speed limit at step 101, write a stress in reach, or a larger "
                 "'patience' where the way is long");
}

TEST(Platen, RefusesASideThatIsNotThere)
{
  expect_refused("grain_stack", R"(
fix top all servo/platen position top z 0.08 side sleeve type 2
run 1
)",
                 "'side' must name a cylinder or sleeve, found 'sleeve' and no fix has that ID, "
                 "define it before");
}

TEST(Cylinder, RefusesAMissingPlaten)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0.05 platens top bottom type 2
fix top all servo/platen position top z 0.08 side side type 2
run 1
)",
                 "'platens' must name a fix servo/platen, found 'bottom' and no fix has that ID, "
                 "define it before");
}

TEST(Cylinder, RefusesAPlatenThatIsSomethingElse)
{
  expect_refused("grain_stack", R"(
fix move all motion
fix top all servo/platen position top z 0.08 side side type 2
fix side all servo/cylinder radius 0.05 platens top move type 2
run 1
)",
                 "'platens' must name a fix servo/platen, found 'move', which is a 'fix motion', "
                 "write the ID of a fix servo/platen");
}

TEST(Cylinder, RefusesPlatensTheWrongWayRound)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0.05 platens bottom top type 2
fix top all servo/platen position top z 0.08 side side type 2
fix bottom all servo/platen position bottom z 0 side side type 2
run 1
)",
                 "'platens' takes the upper platen first, found 'bottom top', write the ID of the "
                 "top and then of the bottom one");
}

TEST(Cylinder, RefusesAStressBelowZero)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0.05 platens top bottom type 2 servo -50e3
run 1
)",
                 "'servo' must be zero or larger, found -50000, write for example 'servo 50000'");
}

TEST(Cylinder, RefusesARadiusOfZero)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0 platens top bottom type 2
run 1
)",
                 "'radius' must be larger than zero, found 0, write for example 'radius 1'");
}

// The platen is taken away after the cylinder felt grains: a ramp has no stress to start from.
TEST(Cylinder, RefusesANewStressWhenItsPlatenWasTakenAway)
{
  const Outcome outcome = run_deck(opening_deck("grain_stack") + R"(
fix side all servo/cylinder radius 0.0199 platens top bottom type 2
fix top all servo/platen position top z 0.08 side side type 2
fix bottom all servo/platen position bottom z 0 side side type 2
fix move all motion
run 1
variable before equal f_side[2]
print "force ${before}"
unfix top
variable stress equal f_side[1]
print "stress ${stress}"
fix_modify side servo 50e3 ramp 10
)");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_GT(outcome.value("force"), 0.0) << outcome.output;
  EXPECT_EQ(outcome.value("stress"), 0.0) << "without a platen there is no loaded area";
  EXPECT_TRUE(
      outcome.says("'platens' must name a fix servo/platen, found 'top' and no fix has "
                   "that ID, define it before"))
      << outcome.output;
}
