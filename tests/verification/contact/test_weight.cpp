// SPDX-License-Identifier: GPL-2.0-only
// Who puts the weight on the grains and clears their forces: `fix motion` where it can, else the
// host.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

constexpr double g = 9.81, height = 0.15, step = 1e-4;
const std::string fall = "timestep 1e-4\n" + material(7e6, 0.5) + grain(0, 0, height) + grain_size;
const std::string weight = "fix weight all gravity 9.81 vector 0 0 -1\n";
const std::string motion = "fix move all motion damping 0 step 1e-4\n";

double fallen(double steps)
{
  return 0.5 * g * steps * step * steps * step;
}

}  // namespace

TEST(Weight, ThatTheHostAppliesIsTheSame)
{
  const std::string run = motion + "run 300\n" + print_numbers("z[1] vz[1] fz[1]");
  const Outcome ours = run_well(fall + weight + run);
  const Outcome host =
      run_well(fall + "variable g equal 9.81\nfix weight all gravity v_g vector 0 0 -1\n" + run);
  for (const char* number : {"z[1]", "vz[1]", "fz[1]"})
    EXPECT_NEAR(ours.value(number), host.value(number), 1e-13) << number;
}

TEST(Weight, OfTwoGravitiesIsTheirSum)
{
  const Outcome outcome = run_well(fall +
                                   "fix one all gravity 4 vector 0 0 -1\n"
                                   "fix two all gravity 5.81 vector 0 0 -1\n" +
                                   motion + "run 300\n" + print_numbers("fz[1] mass[1]"));
  EXPECT_NEAR(outcome.value("fz[1]"), -g * mass, 1e-12);
}

TEST(Weight, HasTheEnergyThatTheHostReports)
{
  const Outcome outcome =
      run_well(fall + weight + motion + "run 100\n" + print_numbers("f_weight z[1]"));
  EXPECT_NEAR(outcome.value("f_weight"), mass * g * outcome.value("z[1]"), 1e-12);
}

// What one fix took over is given back at the end of each run.
TEST(Weight, GoesBackToTheHostWithTheMotion)
{
  const Outcome outcome =
      run_well(fall + weight + motion + "run 100\nunfix move\nfix other all nve/sphere\nrun 100\n" +
               print_numbers("z[1] fz[1]"));
  EXPECT_NEAR(outcome.value("fz[1]"), -g * mass, 1e-12);
  EXPECT_NEAR(outcome.value("z[1]"), height - fallen(200), 1e-6);
}

TEST(Weight, IsThereInARunThatIsNotSetUp)
{
  const std::string start = fall + weight + motion + "run 100\n";
  const std::string print = print_numbers("z[1] fz[1]");
  const Outcome outcome = run_well(start + "run 100 pre no\n" + print);
  EXPECT_NEAR(outcome.value("fz[1]"), -g * mass, 1e-12);
  EXPECT_NEAR(outcome.value("z[1]"), run_well(start + "run 100\n" + print).value("z[1]"), 1e-14);
}

TEST(Weight, OfGrainsOutsideTheGroupIsTheHosts)
{
  const Outcome outcome =
      run_well("timestep 1e-4\n" + material(7e6, 0.5) + grain(0, 0, height) +
               grain(0.05, 0, height) + grain_size +
               "group mine id 1\ngroup others id 2\n"
               "fix weight all gravity 9.81 vector 0 0 -1\n"
               "fix move mine motion damping 0 step 1e-4\nfix rest others nve/sphere\nrun 200\n" +
               print_numbers("z[2] fz[1] fz[2]"));
  EXPECT_NEAR(outcome.value("fz[1]"), -g * mass, 1e-12);
  EXPECT_NEAR(outcome.value("fz[2]"), -g * mass, 1e-12);
  EXPECT_NEAR(outcome.value("z[2]"), height - fallen(200), 1e-6);
}
