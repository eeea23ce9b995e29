// SPDX-License-Identifier: GPL-2.0-only
// What a contact remembers must go when it parts, even if the host builds no list in between.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// Grain 2 goes a way in steps of 10 us: it touches what lies to its left with an overlap of 50 um
/// (0 to 100), is sheared upwards by 50 um (100 to 200), parts (200 to 300), sinks to its first
/// height (300 to 400) and comes back to where it was (400 to 500). The skin of 5 mm makes sure
/// that lists are built once.
std::string sheared_parted_rejoined(const std::string& rest)
{
  return "neighbor 0.005 bin\n"
         "group mover id 2\n"
         "variable t equal step\n"
         "variable vx equal 0.2*(v_t>200)*(v_t<=300)-0.2*(v_t>400)*(v_t<=500)\n"
         "variable vy equal 0.05*(v_t>100)*(v_t<=200)-0.05*(v_t>300)*(v_t<=400)\n"
         "variable dx equal "
         "2e-6*((v_t-200)*(v_t>200)*(v_t<=300)+100*(v_t>300)*(v_t<=400)+(500-v_t)*"
         "(v_t>400)*(v_t<=500))\n"
         "variable dy equal "
         "5e-7*((v_t-100)*(v_t>100)*(v_t<=200)+100*(v_t>200)*(v_t<=300)+(400-v_t)*"
         "(v_t>300)*(v_t<=400))\n"
         "fix path mover move variable v_dx v_dy NULL v_vx v_vy NULL units box\n" +
         rest + "thermo 1000\n" + track_numbers("step fx[2] fy[2]", 1) + "run 600\n";
}

/// The deck of two grains, the left one held.
std::string two_grains(const std::string& rolling)
{
  return material(7e6, 0.5) +
         "fix rollf all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 "
         "0.1\npair_style gran model linear tangential history " +
         rolling + "\npair_coeff * *\n" + grain(0, 0, 0.1) + grain(0.01995, 0, 0.1) + grain_size;
}

void expect_no_memory(const std::string& deck)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(deck, 1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  ASSERT_TRUE(outcome.says("Neighbor list builds = 0")) << "the trap needs one list throughout";
  const CsvTable track(folder.path() / "track.csv");
  const std::vector<double>&when = track.column("step"), &press = track.column("fx[2]"),
        &shear = track.column("fy[2]");
  for (std::size_t n = 0; n < track.rows(); ++n) {
    if (when[n] == 200.0) {
      EXPECT_LT(shear[n], -1.0) << "sheared upwards";
    } else if (when[n] > 300.0 && when[n] <= 400.0) {
      EXPECT_EQ(press[n], 0.0) << "apart";
    } else if (when[n] > 500.0) {
      EXPECT_GT(press[n], 1.0) << "together again";
      EXPECT_NEAR(shear[n], 0.0, 1e-9) << "at step " << when[n];
    }
  }
}

}  // namespace

TEST(ContactMemory, IsGoneWhenTwoGrainsPartAndMeetAgainWithinOneList)
{
  expect_no_memory(two_grains("") + sheared_parted_rejoined(""));
}

TEST(ContactMemory, IsGoneWithRollingResistanceToo)
{
  expect_no_memory(two_grains("rolling_friction epsd2") + sheared_parted_rejoined(""));
}

// A virial sends the pairs through the host's own loop.
TEST(ContactMemory, IsGoneInTheHostsLoopToo)
{
  expect_no_memory(two_grains("") +
                   sheared_parted_rejoined("compute stress all stress/atom\n"
                                           "fix stress all ave/atom 1 1 1 c_stress[1]\n"));
}

// The same against the cylinder, whose inner surface lies to the left of a grain at -x.
TEST(ContactMemory, IsGoneWhenAGrainLeavesAServoWallAndReturns)
{
  expect_no_memory(material(7e6, 0.5) + grain(0.03, 0, 0.1) + grain(-0.03995, 0, 0.1) + grain_size +
                   "fix side all servo/cylinder radius 0.04990 platens top bottom type 2\n" +
                   platen("top", 0.2) + platen("bottom", 0.0) + sheared_parted_rejoined(""));
}

TEST(ContactMemory, IsGoneWhenAGrainLeavesAWallOfTheHostAndReturns)
{
  expect_no_memory(material(7e6, 0.5) + grain(0.03, 0, 0.1) + grain(-0.00005, 0, 0.1) + grain_size +
                   "fix wall all wall/gran model linear tangential history primitive type 2 xplane "
                   "-0.01\n" +
                   sheared_parted_rejoined(""));
}

// A mesh of the host's asks for the host's list, which the host makes again then: springs of the
// run before must be there.
TEST(ContactMemory, OutlivesAnotherChoiceOfListsBetweenTwoRuns)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(
      two_grains("") + "group mover id 2\nfix path mover move linear 0 0.05 0\nrun 100\n" +
          "unfix path\nfix path mover move linear 0 0 0\nvariable fy equal fy[2]\n"
          "variable before equal ${fy}\n" +
          "create_wall_mesh file far.stl shape square half_width 0.002 z 0.205 edge 0.002\n"
          "fix far all mesh/surface file far.stl type 2\n"
          "fix far_wall all wall/gran model linear tangential history mesh n_meshes 1 meshes far\n"
          "run 1\n" +
          print_numbers("fy[2] v_before"),
      1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_LT(outcome.value("fy[2]"), -1.0);
  EXPECT_NEAR(outcome.value("fy[2]"), outcome.value("v_before"),
              1e-12 * std::abs(outcome.value("v_before")));
}

// Grains that touch the cylinder are drawn along its axis, each at its speed, two of them from one
// rank to the other. Springs that went lost or to another grain with any of the lists, which are
// made again with every step, would show: each must be as long as the way.
TEST(ContactMemory, OfAWallGoesWithItsGrainThroughListsAndRanks)
{
  const double step = 1e-5, at = 0.0499 - radius + 5e-5;
  const double speeds[] = {0.04, 0.02, 0.03,
                           0.05};  // m/s; grain 2 takes the place of 4 when that leaves
  std::string paths;
  for (int n = 0; n < 4; ++n) {
    const std::string id = std::to_string(n + 1);
    paths += "group g" + id + " id " + id + "\nfix path" + id + " g" + id + " move linear 0 0 " +
             digits(speeds[n]) + "\n";
  }
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_deck(material(7e6, 10) + grain(at, 0, 0.15) + grain(-at, 0, 0.09999) +
                     grain(0, at, 0.05) + grain(0, -at, 0.09999) + grain(0, 0, 0.02) + grain_size +
                     "neigh_modify every 1 delay 0 check no\n"
                     "fix side all servo/cylinder radius 0.0499 platens top bottom type 2\n" +
                     platen("top", 0.3) + platen("bottom", -0.1) + "timestep " + digits(step) +
                     "\n" + paths + "run 100\n" + print_numbers("fz[1] fz[2] fz[3] fz[4]"),
                 ranks, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    ASSERT_TRUE(outcome.says("Neighbor list builds = 100"));
    for (int n = 0; n < 4; ++n) {
      const double spring = pi * radius * 7e6 * speeds[n] * step * 100;  // N, k_n = k_s = pi r E*
      EXPECT_NEAR(outcome.value("fz[" + std::to_string(n + 1) + "]"), -spring, 1e-9 * spring)
          << "grain " << n + 1 << ", ranks: " << ranks;
    }
  }
}
