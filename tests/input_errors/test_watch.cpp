// SPDX-License-Identifier: GPL-2.0-only
// Runs that went wrong do not pass for results: the history and the motion stop them.
#include "input_errors/refusal.h"

using namespace encased_column::testing;

namespace {

/// Walls about the stack, motion and history; grains or velocities before it.
const std::string watched = R"(
fix side all servo/cylinder radius 0.04 platens top bottom type 2
fix top all servo/platen position top z 0.1 side side type 2
fix bottom all servo/platen position bottom z 0 side side type 2
fix move all motion every 50
fix history all specimen/history platens top bottom side side motion move every 50
thermo_modify lost ignore
run 200
)";

}  // namespace

TEST(Watch, StopsWhereTheCenterOfAGrainIsBeyondTheCylinder)
{
  expect_refused(
      "grain_stack",
      "create_atoms 1 single 0.045 0 0.05 units box\n"
      "set group all diameter 0.02 density 2500\n" +
          watched,
      "1 grains are outside the walls at step 0, where the history begins, which takes all grains "
      "of the box for one specimen: delete those that do not belong to it or set the walls about "
      "them");
}

TEST(Watch, StopsWhereTheCenterOfAGrainIsBeyondAPlaten)
{
  expect_refused("grain_stack",
                 "create_atoms 1 single 0 0 0.105 units box\n"
                 "set group all diameter 0.02 density 2500\n" +
                     watched,
                 "1 grains are outside the walls at step 0");
}

TEST(Watch, StopsWhereAGrainHasLeftTheBox)
{
  expect_refused("grain_stack", "group one id 16\nvelocity one set 0 0 1e6 units box\n" + watched,
                 "of 16 grains 15 are left at step 50, enlarge the box or slow the walls");
}

TEST(Watch, StopsWhereForcesAreNotNumbers)
{
  expect_refused("grain_stack", "fix overflow all addforce 1e308 0 0\n" + watched,
                 "the forces on the grains are not numbers at step 0, go back to the last restart "
                 "file with a smaller step");
}
