// SPDX-License-Identifier: GPL-2.0-only
// The specimen history and the pictures of the grains.
#include "input_errors/refusal.h"

using namespace encased_column::testing;

namespace {

/// Walls, motion and a history with the keywords `history`.
std::string specimen(const std::string& history)
{
  return R"(
fix side all servo/cylinder radius 0.05 platens top bottom type 2
fix top all servo/platen position top z 0.08 side side type 2
fix bottom all servo/platen position bottom z 0 side side type 2
fix move all motion every 50
fix history all specimen/history )" +
         history + "\nrun 1\n";
}

}  // namespace

TEST(History, RefusesAnIntervalThatIsNotAMultipleOfTheMotions)
{
  expect_refused("grain_stack", specimen("platens top bottom side side motion move every 120"),
                 "'every' must be a multiple of the 'every' of fix move, found 120 and 50, write "
                 "for example 'every 200'");
}

TEST(History, RefusesAFileThatCannotBeWritten)
{
  expect_refused("grain_stack",
                 specimen("platens top bottom side side motion move file no_folder/history.csv"),
                 "'file' must be a file that can be written, found 'no_folder/history.csv', create "
                 "its folder or give another name");
}

TEST(History, RefusesPlatensInTheWrongOrder)
{
  expect_refused("grain_stack", specimen("platens bottom top side side motion move"),
                 "'platens' takes the upper platen first, found 'bottom top', write the ID of the "
                 "top and then of the bottom one");
}

TEST(History, RefusesAMissingPlaten)
{
  expect_refused("grain_stack", specimen("platens top lid side side motion move"),
                 "'platens' must name a fix servo/platen, found 'lid' and no fix has that ID, "
                 "define it before");
}

TEST(History, RefusesToBeChangedButForItsReference)
{
  expect_refused("grain_stack",
                 specimen("platens top bottom side side motion move\n"
                          "fix_modify history every 100"),
                 "'fix_modify history' takes 'reference' only, found 'every 100', write "
                 "'fix_modify history reference'");
}

TEST(History, RefusesADeckThatDoesNotNameItsMotion)
{
  expect_refused("grain_stack", specimen("platens top bottom side side"),
                 "keyword 'motion' is missing, add 'motion ...'");
}

TEST(Pictures, RefuseAFolderThatCannotBeWritten)
{
  expect_refused("two_grains",
                 "fix pictures all output/grains every 100 folder /dev/null/grains\nrun 1\n",
                 "'folder' must be a folder that can be written, found '/dev/null/grains', write "
                 "another path or mend its rights");
}

TEST(Pictures, RefuseToBeTakenWithoutAnInterval)
{
  expect_refused("two_grains", "fix pictures all output/grains folder grains\nrun 1\n",
                 "keyword 'every' is missing, add 'every ...'");
}

TEST(Pictures, RefuseARangeOfStrainBelowZero)
{
  expect_refused(
      "two_grains",
      "fix pictures all output/grains every 100 folder grains strain_range -1\nrun 1\n",
      "'strain_range' must be zero or larger, found -1, write for example 'strain_range 1'");
}

TEST(Pictures, TakeTwoOrdersOnly)
{
  for (const std::string order : {"write", "write later", "begin now"})
    expect_refused("two_grains",
                   "fix pictures all output/grains every 100 folder grains\n"
                   "fix_modify pictures " +
                       order + "\nrun 1\n",
                   "'fix_modify pictures' takes 'reset' or 'write now', found '" + order +
                       "', write for example 'fix_modify pictures write now'");
}

TEST(Chains, RefuseAFolderThatCannotBeWritten)
{
  expect_refused("two_grains",
                 "fix chains all output/contacts every 100 folder /dev/null/chains\nrun 1\n",
                 "'folder' must be a folder that can be written, found '/dev/null/chains', write "
                 "another path or mend its rights");
}

TEST(Chains, RefuseAFileThatCannotBeWritten)
{
  expect_refused("two_grains",
                 "fix chains all output/contacts every 100 folder chains file no_folder/c.csv\n"
                 "run 1\n",
                 "'file' must be a file that can be written, found 'no_folder/c.csv', create its "
                 "folder or give another name");
}

TEST(Chains, RefuseAThresholdThatIsNoNumber)
{
  expect_refused(
      "two_grains", "fix chains all output/contacts every 100 folder chains threshold 5N\nrun 1\n",
      "'threshold' takes a finite number, found '5N', write for example '0.5' in its place");
}

TEST(Chains, RefuseALevelOfZero)
{
  expect_refused("two_grains",
                 "fix chains all output/contacts every 100 folder chains level 0\nrun 1\n",
                 "'level' must be larger than zero, found 0, write a force in N");
}

TEST(Collection, RefusesAPartThatComesAfterIt)
{
  expect_refused("two_grains",
                 "fix together all output/collection part chains\n"
                 "fix chains all output/contacts every 100 folder chains\nrun 1\n",
                 "'part' must name a fix that writes a series, found 'chains' and no fix has that "
                 "ID, define it before");
}

TEST(Collection, RefusesAPartThatHasBeenTakenAway)
{
  expect_refused("two_grains",
                 "fix chains all output/contacts every 100 folder chains\n"
                 "fix together all output/collection part chains\nunfix chains\nrun 1\n",
                 "'part' must name a fix that writes a series, found 'chains' and no fix has that "
                 "ID, define it before");
}

TEST(Collection, RefusesAPartOfAnotherKind)
{
  expect_refused("two_grains", "fix together all output/collection part move\nrun 1\n",
                 "'part' must name a fix that writes a series, found 'move', which is a 'fix "
                 "nve/sphere', write the ID of a fix that writes a series");
}

TEST(Collection, RefusesSpheresWithoutFiles)
{
  expect_refused("two_grains",
                 "fix balls all measure/sphere sphere 0 0 0.1 0.05\n"
                 "fix together all output/collection part balls\nrun 1\n",
                 "'part' must name a fix that writes a series, found 'balls', which writes no VTK "
                 "files, add 'folder ...' to it");
}
