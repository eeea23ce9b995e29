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
                 "speed_limit");
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
                 "'platens' must name a fix servo/platen, found 'move', which is a 'fix motion'");
}

TEST(Cylinder, RefusesAStressBelowZero)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0.05 platens top bottom type 2 servo -50e3
run 1
)",
                 "'servo' must be zero or larger, found -50000");
}

TEST(Cylinder, RefusesARadiusOfZero)
{
  expect_refused("grain_stack", R"(
fix side all servo/cylinder radius 0 platens top bottom type 2
run 1
)",
                 "'radius' must be larger than zero, found 0");
}
