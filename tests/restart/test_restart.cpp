// SPDX-License-Identifier: GPL-2.0-only
// A run that stops, writes a restart file and goes on in a new process is the same run, bit by bit.
#include "restart/specimen_deck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const std::string consolidation =
    "run 1000\nunfix grow\nrun 500\n"
    "fix_modify side servo 50e3 ramp 1000\n"
    "fix_modify bottom servo 50e3 ramp 1000\n";

const std::string shear =
    consolidation + "run 2000\n" + history + "fix_modify bottom velocity 1e-6\n";

void run_in(const fs::path& folder, const std::string& deck)
{
  const Outcome outcome = run_deck(deck, 1, folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
}

std::string run_steps(long steps)
{
  return "run " + std::to_string(steps) + "\n";
}

/// What is compared: the steps after the stop and the grains at their end.
std::string rest(const std::string& file)
{
  return run_steps(300) + picture(file);
}

/// Stops a new specimen `steps` after `before` and goes on, in the same process and, with `again`
/// given again, in another one; both must leave the same grains.
void expect_the_same_run(const fs::path& folder, const std::string& before, long steps,
                         const std::string& again)
{
  run_in(folder, new_specimen(before + run_steps(steps) + "write_restart stop\n" + rest("whole")));
  run_in(folder, specimen_of("stop", again + rest("parts")));
  EXPECT_GT(fs::file_size(folder / "whole"), 10000u);
  EXPECT_EQ(read_text(folder / "parts"), read_text(folder / "whole"));
}

/// Numbers of a picture, grain by grain.
std::vector<double> numbers_of(const fs::path& file)
{
  std::istringstream text(read_text(file));
  std::string line;
  for (int n = 0; n < 9; ++n) std::getline(text, line);
  std::vector<double> numbers;
  for (double number; text >> number;) numbers.push_back(number);
  return numbers;
}

/// Starts a deck that would run for an hour, sends it `signal` after step 1200, waits for its end
/// and returns the step of the restart file it left.
long step_of_interrupted(const fs::path& folder, const std::string& deck, const std::string& signal)
{
  std::ofstream(folder / "in.lmp") << deck + "print \"went on\"\n";
  const Outcome outcome = run_program({"bash", "-c",
                                       "'" ENCASE_PROGRAM "' -in in.lmp & child=$!\n"
                                       "until grep -q '^ *1200 ' log.liggghts 2>/dev/null; do\n"
                                       "  kill -0 $child || exit 1\n"
                                       "  sleep 0.05\n"
                                       "done\n"
                                       "kill -" +
                                           signal + " $child\nwait $child"},
                                      folder);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_FALSE(outcome.says("went on")) << "the deck ends at the signal";
  const std::string begin = "restart_forced_liggghts_";
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.rfind(begin, 0) == 0) return std::stol(name.substr(begin.size()));
  }
  ADD_FAILURE() << "no restart file was left\n" << outcome.output;
  return 0;
}

/// The deck with grains in the order of their making. The host sorts them when it builds a list,
/// more often in a run that stopped, and another order gives other round-off.
std::string unsorted(std::string deck)
{
  const std::string map = "map array";
  return deck.insert(deck.find(map) + map.size(), " sort 0 0");
}

void expect_to_go_on_after(const std::string& signal, const std::string& before,
                           const std::string& command)
{
  const TemporaryFolder folder;
  const long step =
      step_of_interrupted(folder.path(), unsorted(new_specimen(before + command)), signal);
  ASSERT_GE(step, 1200);
  const std::string file = "restart_forced_liggghts_" + std::to_string(step) + ".data";
  run_in(folder.path(), unsorted(specimen_of(file, rest("parts"))));
  // The same steps without a signal. For a file that it writes during a run the host builds a list
  // at that step; without one, grains that are in other bins than at the last list give a list in
  // another order, and sums other round-off.
  run_in(folder.path(),
         unsorted(new_specimen(before + "restart " + std::to_string(step) + " same.*\n" +
                               run_steps(step - 1000) + rest("whole"))));
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

}  // namespace

// What the deck changes between reading the file and the first step finds the walls as they were.
TEST(Restart, RampsOfWallsThatAreChangedAtOnceStartFromTheStressOfTheFile)
{
  const TemporaryFolder folder;
  const std::string change = "fix_modify bottom servo 50e3 ramp 1000\n";
  run_in(folder.path(), new_specimen(consolidation + run_steps(2000) + "write_restart stop\n" +
                                     change + rest("whole")));
  run_in(folder.path(), specimen_of("stop", change + rest("parts")));
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

// As a stage of the decks that ends at once, before any step.
TEST(Restart, LeavesNoFileWhereNoStepFollows)
{
  const TemporaryFolder folder;
  run_in(folder.path(),
         new_specimen("fix save all output/restart every 100 file saved\nunfix save\n"));
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_NE(entry.path().filename().string().rfind("saved", 0), 0u) << entry.path();
}

TEST(Restart, GoesOnWhileRadiiGrow)
{
  const TemporaryFolder folder;
  expect_the_same_run(folder.path(), "", 613, growth);
}

// Stopped between two looks at the stress, with friction that is lower than the deck says, and
// where a look is due in the next step.
TEST(Restart, GoesOnWhileFrictionGivesWayToTheGrowth)
{
  const std::string minded =
      "fix grow all grow/radius from 0.5 stages 50 relax 50 stress 5e3 platens top bottom side "
      "side\n";
  for (const long stop : {4613L, 4600L}) {
    const TemporaryFolder folder;
    const std::string during = "restart " + std::to_string(stop) + " during.*\n";
    const std::string last = "run " + std::to_string(stop + 487) + " upto\n" +
                             "variable friction equal f_grow[3]\nprint \"friction ${friction}\"\n" +
                             picture("grains");
    const auto with_growth = [&](std::string deck) {
      deck.replace(deck.find(growth), growth.size(), minded);
      return unsorted(deck);
    };
    const Outcome whole = run_deck(with_growth(new_specimen(during + last)), 1, folder.path());
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    EXPECT_LT(whole.value("friction"), 0.8);
    EXPECT_GT(whole.value("friction"), 0.1);
    const std::string grains = read_text(folder.path() / "grains");
    run_in(folder.path(), unsorted(specimen_of("during." + std::to_string(stop), minded + last)));
    EXPECT_GT(grains.size(), 10000u);
    EXPECT_EQ(read_text(folder.path() / "grains"), grains) << "from step " << stop;
  }
}

TEST(Restart, GoesOnInTheRampOfAServo)
{
  const TemporaryFolder folder;
  expect_the_same_run(folder.path(), consolidation, 437, "");
}

// The rows that the first process wrote after the stop are dropped and come again.
TEST(Restart, GoesOnInShearAndWithTheHistory)
{
  const TemporaryFolder folder;
  expect_the_same_run(folder.path(), shear, 420, "");
  const std::string rows = read_text(folder.path() / "history.csv");
  EXPECT_NE(rows.find("\n3500,"), std::string::npos);
  EXPECT_NE(rows.find("\n4200,"), std::string::npos);
  run_in(folder.path(), specimen_of("stop", history + rest("parts")));
  EXPECT_EQ(read_text(folder.path() / "history.csv"), rows);
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

// `restart` writes in the middle of a run, where the host's own copy of the shear springs is a step
// old.
TEST(Restart, FromAFileWrittenDuringARunIsTheSameAsFromOneWrittenAfterIt)
{
  const TemporaryFolder folder;
  run_in(folder.path(),
         unsorted(new_specimen(shear + "restart 3900 during.*\nrun 400\nwrite_restart stop\n")));
  run_in(folder.path(), unsorted(specimen_of("stop", rest("whole"))));
  run_in(folder.path(), unsorted(specimen_of("during.3900", rest("parts"))));
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

// With the host's law and motion its list keeps the springs, and no fix of ours saves them.
TEST(Restart, FromAFileWrittenDuringARunKeepsTheSpringsOfTheHostsLawToo)
{
  const std::string law = R"(
neighbor       0.0005 bin
pair_style     gran model hooke/stiffness tangential history
pair_coeff     * *
fix            kn all property/global kn peratomtypepair 3 3e4 3e4 3e4 3e4 3e4 3e4 3e4 3e4 3e4
fix            kt all property/global kt peratomtypepair 3 1e4 1e4 1e4 1e4 1e4 1e4 1e4 1e4 1e4
fix            gn all property/global gamman peratomtypepair 3 0 0 0 0 0 0 0 0 0
fix            gt all property/global gammat peratomtypepair 3 0 0 0 0 0 0 0 0 0
fix            mu all property/global coefficientFriction peratomtypepair 3 9 9 9 9 9 9 9 9 9
fix            move all nve/sphere
timestep       1e-6
)";
  const std::string two_grains =
      "create_atoms 1 single 0 0 0.02 units box\ncreate_atoms 1 single 0.0099 0 0.02 units box\n"
      "set group all diameter 0.01\nset group all density 2000\nvelocity all set 0 0 0\n"
      "set atom 1 vy 0.1\n";
  const std::string last = "run 100 upto\n" + picture("grains");
  const TemporaryFolder folder;
  run_in(folder.path(), host + box + law + two_grains + "restart 50 during.*\n" + last);
  const std::string whole = read_text(folder.path() / "grains");
  run_in(folder.path(), host + "read_restart during.50\n" + law + last);
  EXPECT_GT(whole.size(), 300u);
  EXPECT_EQ(read_text(folder.path() / "grains"), whole);
}

// Inertia, stable step and equilibrium are found again every 50 steps, and not where a run stops:
// the file of step 3937 goes on as the run that wrote it did.
TEST(Restart, GoesOnAtAnyStepAsTheRunThatWroteTheFileWithoutAStop)
{
  for (const std::string step : {"1.0", "stable"}) {
    const TemporaryFolder folder;
    const auto with_step = [&](std::string deck) {
      const std::string scaled = "step 1.0";
      return unsorted(deck.replace(deck.find(scaled), scaled.size(), "step " + step));
    };
    const std::string slow =
        "fix_modify bottom velocity " + std::string(step == "stable" ? "1e-3" : "1e-6") + "\n";
    const std::string last = "run 4200 upto\n" + picture("grains");
    run_in(folder.path(), with_step(new_specimen(shear + slow + "restart 3937 during.*\n" + last)));
    const std::string whole = read_text(folder.path() / "grains");
    run_in(folder.path(), with_step(specimen_of("during.3937", last)));
    EXPECT_GT(whole.size(), 10000u);
    EXPECT_EQ(read_text(folder.path() / "grains"), whole) << "with step " << step;
  }
}

// The set-up of a run compares all wall contacts with the inertia, a step only new ones: that must
// find nothing to raise, also where the wall is stiffer than the grains, whose sums per axis ask
// less for an oblique contact than the contact itself does, and where radii have just grown.
TEST(Restart, GoesOnAtAnyStepWhereTheWallIsStiff)
{
  const auto with_stiff_side = [](std::string deck) {
    for (const auto& [from, to] :
         {std::pair{"7e6 7e6 7e6 7e6 7e6 7e6 7e6 7e6 7e6", "7e6 7e6 7e7 7e6 7e6 7e6 7e7 7e6 7e7"},
          std::pair{"2 2 2 2 2 2 2 2 2", "3.5 3.5 3.5 3.5 3.5 3.5 3.5 3.5 3.5"},
          std::pair{" rolling_friction epsd2", ""}})
      deck.replace(deck.find(from), std::string(from).size(), to);
    return unsorted(deck);
  };
  for (const long stop : {613L, 3937L}) {
    const TemporaryFolder folder;
    const std::string during = "restart " + std::to_string(stop) + " during.*\n";
    const std::string last = "run " + std::to_string(stop + 263) + " upto\n" + picture("grains");
    const bool grows = stop < 1000;
    run_in(folder.path(), with_stiff_side(new_specimen((grows ? "" : shear) + during + last)));
    const std::string whole = read_text(folder.path() / "grains");
    run_in(folder.path(), with_stiff_side(specimen_of("during." + std::to_string(stop),
                                                      (grows ? growth : "") + last)));
    EXPECT_GT(whole.size(), 10000u);
    EXPECT_EQ(read_text(folder.path() / "grains"), whole) << "from step " << stop;
  }
}

// Without a stop the lists are built at other steps and forces are summed in another order:
// round-off, which local damping, a switch on the sign of small velocities, makes grow tenfold in
// some 30 steps.
TEST(Restart, StaysWithTheRunThatNeverStoppedToRoundOff)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_specimen(shear + run_steps(400 + 50) + picture("whole")));
  run_in(folder.path(), new_specimen(shear + run_steps(400) + "write_restart stop\n"));
  run_in(folder.path(), specimen_of("stop", run_steps(50) + picture("parts")));
  const std::vector<double> whole = numbers_of(folder.path() / "whole"),
                            parts = numbers_of(folder.path() / "parts");
  ASSERT_GT(whole.size(), 1000u);
  ASSERT_EQ(whole.size(), parts.size());
  for (std::size_t n = 0; n < whole.size(); ++n)
    ASSERT_NEAR(parts[n], whole[n], 1e-9 * std::abs(whole[n]) + 1e-12) << "number " << n;
}

TEST(Restart, GoesOnAfterTheSignalOfKill)
{
  expect_to_go_on_after("TERM", "run 1000\nunfix grow\n", "run 100000000\n");
}

TEST(Restart, GoesOnAfterControlCInSolve)
{
  expect_to_go_on_after("INT", "run 1000\nunfix grow\n",
                        "solve ratio average 1e-30 every 50 max 100000000\n");
}

TEST(Restart, TakesTheDriveThatAFixLineNames)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_specimen(shear + "run 10\nwrite_restart stop\n"));
  const std::string heights =
      "variable low equal f_bottom[3]\nvariable high equal f_top[3]\nrun 0\nvariable a equal "
      "${low}\n"
      "variable c equal ${high}\nrun 100\nvariable up equal f_bottom[3]-v_a\n"
      "variable down equal v_c-f_top[3]\nprint \"up ${up}\"\nprint \"down ${down}\"\n";
  std::string deck = specimen_of("stop", heights);
  const std::string top =
      "fix            top all servo/platen position top z 0.05 side side type 2";
  ASSERT_NE(deck.find(top), std::string::npos);
  deck.insert(deck.find(top) + top.size(), " velocity 2e-6");
  const Outcome outcome = run_deck(deck, 1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NEAR(outcome.value("up"), 100 * 1e-6, 1e-12) << "as in the restart file";
  EXPECT_NEAR(outcome.value("down"), 100 * 2e-6, 1e-12) << "as the fix line says";
}
