// SPDX-License-Identifier: GPL-2.0-only
#include "input_errors/refusal.h"

using namespace encased_column::testing;

TEST(Motion, RefusesAnUnknownKeyword)
{
  expect_refused(
      "two_grains", R"(
unfix move
fix   move all motion dampnig 0.7
run   1
)",
      "unknown keyword 'dampnig', expected one of: damping, step, safety, every, free_speed");
}

TEST(Motion, RefusesAKeywordWithoutItsValue)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion damping
run   1
)",
                 "keyword 'damping' takes 1 value, found 0, add what is missing: local damping "
                 "alpha, 0 to 0.99 (default 0.7)");
}

TEST(Motion, SaysWhichValueIsMissingWhenAKeywordStandsInItsPlace)
{
  expect_refused(
      "two_grains", R"(
unfix move
fix   move all motion damping step 1e-6
run   1
)",
      "unknown keyword '1e-6', expected one of: damping, step, safety, every, free_speed; or "
      "'damping' lacks a value, its last is 'step'");
}

TEST(Motion, RefusesAKeywordThatStandsTwice)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion damping 0.7 damping 0.5
run   1
)",
                 "keyword 'damping' stands twice, write it once");
}

TEST(Motion, RefusesDampingOutOfRange)
{
  expect_refused(
      "two_grains", R"(
unfix move
fix   move all motion damping 1.5
run   1
)",
      "'damping' must be between 0 and 0.99, found 1.5, write for example 'damping 0.5'");
}

TEST(Motion, RefusesHalfANumber)
{
  expect_refused(
      "two_grains", R"(
unfix move
fix   move all motion safety 0.1.7
run   1
)",
      "'safety' takes a finite number, found '0.1.7', write for example '0.5' in its place");
}

TEST(Motion, RefusesAStepBelowZero)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion step -1
run   1
)",
                 "'step' must be 'stable' or a number larger than zero, found '-1', write 'step "
                 "stable' or for example 'step 1e-6'");
}

TEST(Motion, RefusesDensityScalingWithDashpots)
{
  expect_refused("two_grains", R"(
fix   dashpot all property/global dampingRatioNormal peratomtypepair 2 0.2 0.2 0.2 0.2
unfix move
fix   move all motion step 1e-3
run   1
)",
                 "'dampingRatioNormal' must be 0 with density scaling, found 0.2, write 'step "
                 "stable' or no dashpots");
}

TEST(Motion, RefusesGrainsWithoutARadius)
{
  const Outcome outcome = run_deck(R"(
units      si
atom_style atomic
region     box block 0 1 0 1 0 1 units box
create_box 1 box
fix        move all motion
)");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(
      outcome.says("'motion' needs grains with a radius and a mass, found 'atom_style atomic', "
                   "write 'atom_style granular'"))
      << outcome.output;
}

TEST(Motion, RefusesToChangeItsStepLater)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion
fix_modify move damping 0.5 step 1e-6
run   1
)",
                 "'fix_modify move' changes 'damping' and 'free_speed' only, found 'step', make a "
                 "new fix for the rest");
}

TEST(Motion, RefusesADeckWithoutContactModulus)
{
  expect_refused("two_grains", R"(
unfix modulus
unfix move
fix   move all motion
run   1
)",
                 "the linear contact law needs 'contactModulus'");
}

TEST(Solve, RefusesADeckWithoutMotion)
{
  expect_refused("two_grains", "solve ratio average 1e-5\n",
                 "'solve' needs one 'fix motion', found 0, write 'fix move all motion' before it");
}

TEST(Solve, RefusesToStandBeforeTheBox)
{
  const Outcome outcome = run_deck("units si\nsolve ratio average 1e-5\n");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(
      outcome.says("'solve' must stand behind the command that makes the box, found no box "
                   "yet, write 'create_box' or 'read_restart' before it"))
      << outcome.output;
}

TEST(Solve, RefusesAnIntervalThatIsNotAMultipleOfTheMotions)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion every 50
solve ratio average 1e-5 every 120
)",
                 "'every' must be a multiple of the 'every' of fix move, found 120 and 50, write "
                 "for example 'every 100'");
}

TEST(Solve, RefusesALimitOfZero)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion
solve ratio average 0
)",
                 "'ratio' takes a limit larger than zero, found 0, write 'ratio average 1e-5'");
}

TEST(Solve, RefusesADampingThatLetsNothingMove)
{
  expect_refused("two_grains", R"(
unfix move
fix   move all motion
solve ratio average 1e-5 damping 1
)",
                 "'damping' must be between 0 and 0.99, found 1, write for example 'damping 0.5'");
}

TEST(Solve, RefusesARatioItDoesNotKnow)
{
  expect_refused(
      "two_grains", R"(
unfix move
fix   move all motion
solve ratio mean 1e-5
)",
      "'ratio' must be one of: average, maximum, bearing; found 'mean', write for example 'ratio "
      "average 1e-5'");
}
