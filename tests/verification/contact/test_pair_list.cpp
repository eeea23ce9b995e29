// SPDX-License-Identifier: GPL-2.0-only
// Our own list of pairs and our loops over it against the host's, in the same run otherwise.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// 1 400 grains of 4 to 16 mm grow until they overlap by gravity and each other, with friction,
/// over many lists, `with` a wall, or go on for twice three steps `then` with another pair style
/// (more would amplify the last digits); more ranks than one have ghosts.
std::string growing_grains(const std::string& with, const std::string& then)
{
  return opening_deck("empty_cylinder") +
         "print \"diameter_low [m],diameter_high [m],mass_percent [%]\" file gravel.csv\n"
         "print \"0.004,0.008,40\" append gravel.csv\n"
         "print \"0.008,0.016,60\" append gravel.csv\n" +
         with +
         "create_packing gradation gravel.csv cylinder 0.05 0 0.1 porosity 0.3 density 1738 type 1 "
         "seed 1\n"
         "fix grow all grow/radius from 0.5 stages 40 relax 10\n"
         "fix low all wall/gran model linear tangential history primitive type 2 zplane 0.0\n"
         "fix gravity all gravity 9.8 vector 0 0 -1\n"
         "fix move all motion step 1.0 every 10\n"
         "thermo 100000\n"
         "run 200\n" +
         then + "run 3\nrun 3\n" +
         print_numbers("f_move[1] f_move[5] f_move[6] z[1] vz[7] fx[100]");
}

// A triangle of the host's out of reach: with a mesh of the host's there, its list is made.
const std::string host_mesh =
    "create_wall_mesh file far.stl shape square half_width 0.002 z 0.205 edge 0.002\n"
    "fix far all mesh/surface file far.stl type 2\n"
    "fix far_wall all wall/gran model linear tangential history mesh n_meshes 1 meshes far\n";

void expect_the_same(const std::string& deck, const std::string& other, int ranks)
{
  const TemporaryFolder folder;
  const Outcome one = run_deck(deck, ranks, folder.path());
  const Outcome two = run_deck(other, ranks, folder.path());
  ASSERT_EQ(one.exit_code, 0) << one.output;
  ASSERT_EQ(two.exit_code, 0) << two.output;
  EXPECT_GT(one.value("f_move[6]"), 1000.0);
  for (const char* name : {"f_move[1]", "f_move[5]", "f_move[6]", "z[1]", "vz[7]", "fx[100]"})
    EXPECT_NEAR(one.value(name), two.value(name), 1e-9 * std::abs(two.value(name))) << name;
}

const std::string rolling =
    "fix roll all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.2 0.2 0.2\n";

void expect_the_same_loops(const std::string& words, const std::string& loop, int ranks)
{
  const std::string style = "pair_style gran model linear tangential history " + words;
  const std::string end = "\npair_coeff * *\n";
  expect_the_same(growing_grains(rolling, style + loop + end),
                  growing_grains(rolling, style + " loop host" + end), ranks);
}

double number_after(const Outcome& outcome, const std::string& words)
{
  const std::size_t place = outcome.output.rfind(words);
  return place == std::string::npos ? 0.0 : std::stod(outcome.output.substr(place + words.size()));
}

/// Loose grains of which some fly into others, which get fast only then, and against a platen.
/// Without damping, which turns with the sign of a velocity: lists in another order add up to other
/// last digits.
std::string flying_grains(const std::string& with)
{
  return opening_deck("empty_cylinder") +
         "print \"diameter_low [m],diameter_high [m],mass_percent [%]\" file gravel.csv\n"
         "print \"0.004,0.008,40\" append gravel.csv\n"
         "print \"0.008,0.016,60\" append gravel.csv\n"
         "create_packing gradation gravel.csv cylinder 0.05 0 0.1 porosity 0.6 density 1738 type "
         "1 "
         "seed 1\n"
         "fix grow all grow/radius from 0.5 stages 20 relax 10\n"
         "fix low all servo/platen position bottom z 0 area 1 type 2\n"
         "fix move all motion damping 0 step 1.0 every 10\n" +
         with +
         "thermo 100000\n"
         "run 200\n"
         "unfix grow\n"
         "group fast id 1:10000:40\n"
         "velocity all set 1e-7 0 0 units box\n"
         "velocity fast set 0 0 -2e-5 units box\n"
         "run 200\n" +
         print_numbers("f_move[5] f_move[6] f_low[1] z[1] vz[7] vx[100]");
}

// A wall of the host's, out of reach: with it the host decides when lists are made.
const std::string host_wall =
    "fix far all wall/gran model linear tangential history primitive type 2 zplane -1.0\n";

void expect_the_same_flights(int ranks)
{
  const TemporaryFolder folder;
  const Outcome ours = run_deck(flying_grains(""), ranks, folder.path());
  const Outcome hosts = run_deck(flying_grains(host_wall), ranks, folder.path());
  ASSERT_EQ(ours.exit_code, 0) << ours.output;
  ASSERT_EQ(hosts.exit_code, 0) << hosts.output;
  EXPECT_GT(ours.value("f_move[6]"), 20.0);
  for (const char* name : {"f_move[5]", "f_move[6]", "f_low[1]", "z[1]", "vz[7]", "vx[100]"})
    EXPECT_NEAR(ours.value(name), hosts.value(name), 1e-9 * std::abs(hosts.value(name))) << name;
  const std::string builds = "Neighbor list builds = ";
  EXPECT_LT(2.0 * number_after(ours, builds), number_after(hosts, builds));
  EXPECT_GT(number_after(ours, builds), 2.0);
}

/// A small grain flies into a large one at rest that lies 1 mm behind a border, from so far that it
/// is no ghost there when lists are made. `lines` go before the motion.
Outcome hit_across_border(const std::string& x_boundary, double border, double other_side,
                          int ranks, const std::string& lines = "")
{
  const auto at = [](double x) { return digits(x) + " 0 0 units box\n"; };
  return run_deck(
      "units si\natom_style granular\natom_modify map array\nnewton off\nboundary " + x_boundary +
          " f f\ncommunicate single vel yes\nprocessors * 1 1\n"
          "region box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box\ncreate_box 2 box\n"
          "neighbor 0.0002 bin\nneigh_modify every 1 delay 0 check yes\n"
          "fix modulus all property/global contactModulus peratomtypepair 2 7e6 7e6 7e6 7e6\n"
          "fix kappa all property/global stiffnessRatio peratomtypepair 2 1 1 1 1\n"
          "fix friction all property/global coefficientFriction peratomtypepair 2 0 0 0 0\n"
          "pair_style gran model linear tangential history\npair_coeff * *\n"
          "create_atoms 1 single " +
          at(border + 0.001) + "create_atoms 1 single " + at(other_side - 0.0115) +
          "set atom 1 diameter 0.02 density 2500\nset atom 2 diameter 0.002 density 2500\n"
          "group small id 2\nvelocity small set 0.1 0 0 units box\n" +
          lines + "fix move all motion damping 0 every 10\nthermo 100000\nrun 3000\n" +
          print_numbers("vx[1] vx[2]"),
      ranks);
}

/// What the small grain loses the large one gets, whose mass is 1 000 times its.
void expect_push_and_answer(const Outcome& outcome)
{
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_LT(outcome.value("vx[2]"), -0.09);
  EXPECT_NEAR(1000.0 * outcome.value("vx[1]") + outcome.value("vx[2]"), 0.1, 1e-12);
}

}  // namespace

TEST(PairList, PushesBothGrainsThatMeetAcrossAPeriodicBorder)
{
  expect_push_and_answer(hit_across_border("p", -0.05, 0.05, 1));
}

TEST(PairList, PushesBothGrainsThatMeetAcrossABorderOfRanks)
{
  expect_push_and_answer(hit_across_border("f", 0.0, 0.0, 2));
}

// Ghosts that come from farther leave wide reaches at a border too.
TEST(PairList, PushesBothGrainsWhereTheDeckAsksForMoreGhosts)
{
  expect_push_and_answer(
      hit_across_border("f", 0.0, 0.0, 2, "communicate single cutoff 0.03 vel yes\n"));
}

TEST(PairList, HoldsLongerAndGivesTheSameForcesWhereEachGrainHasItsOwnReach)
{
  expect_the_same_flights(1);
}

TEST(PairList, HoldsLongerAndGivesTheSameForcesOnTwoRanks)
{
  expect_the_same_flights(2);
}

// Lists that computes ask for hold for half the skin.
TEST(PairList, LeavesListsToTheHostWhereAComputeHasOne)
{
  const std::string compute = "compute near all coord/atom 0.004\n";
  const TemporaryFolder folder;
  const Outcome with = run_deck(flying_grains(compute), 1, folder.path());
  const Outcome hosts = run_deck(flying_grains(host_wall), 1, folder.path());
  ASSERT_EQ(with.exit_code, 0) << with.output;
  const std::string builds = "Neighbor list builds = ";
  EXPECT_EQ(number_after(with, builds), number_after(hosts, builds));
}

TEST(PairList, GivesTheForcesOfTheHostsList)
{
  expect_the_same(growing_grains("", ""), growing_grains(host_mesh, ""), 1);
}

TEST(PairList, GivesTheForcesOfTheHostsListOnTwoRanks)
{
  expect_the_same(growing_grains("", ""), growing_grains(host_mesh, ""), 2);
}

TEST(PairLoop, GivesTheForcesOfTheHostsTemplate)
{
  expect_the_same_loops("", "", 2);
}

// The host's loop makes the stress that the deck asks for, and leaves the steps between to ours.
TEST(PairLoop, TakesTurnsWithTheHostsTemplate)
{
  const std::string by_turns =
      "compute t all temp\ncompute p all pressure t\nthermo_style custom step c_p\nthermo 2\n";
  for (const int ranks : {1, 2})
    expect_the_same(growing_grains("", by_turns), growing_grains("", ""), ranks);
}

TEST(PairLoop, OneByOneGivesTheForcesOfTheHostsTemplate)
{
  expect_the_same_loops("", " loop single", 1);
  expect_the_same_loops("rolling_friction epsd2", " loop single", 1);
}

TEST(PairLoop, GivesTheForcesOfTheHostsTemplateWithRollingResistance)
{
  expect_the_same_loops("rolling_friction epsd2", "", 1);
}
