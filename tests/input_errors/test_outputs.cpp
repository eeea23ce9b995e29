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
