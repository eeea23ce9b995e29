// SPDX-License-Identifier: GPL-2.0-only
// Local damping in a run: a grain between two platens is a mass on a spring.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// Heights at which the grain turns, its own equilibrium at zero, released at 50 um.
std::vector<double> turning_points(const std::string& motion)
{
  const CsvTable track =
      track_of(material(7e6, 0.0) + grain(0, 0, 0.10005) + grain_size +
               platen("top", 0.1 + radius - 1e-4) + platen("bottom", 0.1 - radius + 1e-4) + motion +
               "thermo 10000\n" + track_numbers("z[1]", 1) + "run 3000\n");
  std::vector<double> points;
  const std::vector<double>& z = track.column("z[1]");
  for (std::size_t n = 1; n + 1 < z.size(); ++n)
    if ((z[n] - z[n - 1]) * (z[n + 1] - z[n]) <= 0.0) points.push_back(z[n] - 0.1);
  return points;
}

}  // namespace

// (x1 / x0)^2 = (1 - alpha) / (1 + alpha) in every half cycle: the force is (1 - alpha) k x while
// it speeds the grain up and (1 + alpha) k x while it slows it down.
TEST(LocalDamping, ShrinksEveryHalfCycleByTheSameFactor)
{
  const double alpha = 0.3;
  const std::vector<double> points =
      turning_points("fix move all motion damping 0.3 safety 0.01\n");
  ASSERT_GT(points.size(), 4u);
  double before = 50e-6;
  for (int n = 0; n < 4; ++n) {
    const double expected = -before * std::sqrt((1.0 - alpha) / (1.0 + alpha));
    EXPECT_NEAR(points[n], expected, 1e-3 * std::abs(expected)) << "half cycle " << n + 1;
    before = points[n];
  }
}

TEST(LocalDamping, OfZeroLeavesTheSwingAsItIs)
{
  const std::vector<double> points = turning_points("fix move all motion damping 0 safety 0.01\n");
  ASSERT_GT(points.size(), 4u);
  EXPECT_NEAR(points[0], -50e-6, 1e-4 * 50e-6);
  EXPECT_NEAR(points[3], 50e-6, 1e-4 * 50e-6);
}

TEST(LocalDamping, DoesNotSlowSteadyMotion)
{
  const Outcome outcome =
      run_well(material(7e6, 0.0) + grain(0, 0, 0.1) + grain_size + velocity(0.3, 0, -0.1) +
               "fix move all motion damping 0.7\nrun 500\n" + print_numbers("vx[1] vz[1]"));
  EXPECT_EQ(outcome.value("vx[1]"), 0.3);
  EXPECT_EQ(outcome.value("vz[1]"), -0.1);
}

// Speed 0.5 m/s, allowed 0.2: it keeps its direction, and the kinetic energy it loses is booked.
TEST(FreeSpeed, SlowsAGrainThatTouchesNothing)
{
  const Outcome outcome = run_well(
      material(7e6, 0.0) + grain(0, 0, 0.1) + grain_size + velocity(0.3, 0, -0.4) +
      "fix move all motion free_speed 0.2\nrun 10\n" + print_numbers("vx[1] vz[1] f_move[5]"));
  EXPECT_NEAR(outcome.value("vx[1]"), 0.12, 1e-12);
  EXPECT_NEAR(outcome.value("vz[1]"), -0.16, 1e-12);
  EXPECT_NEAR(outcome.value("f_move[5]"), 0.5 * mass * (0.25 - 0.04), 1e-9 * mass);
}

TEST(FreeSpeed, LimitsAFallToo)
{
  const Outcome outcome =
      run_well(material(7e6, 0.0) + grain(0, 0, 0.1) + grain_size + velocity(0, 0, -0.1) +
               "fix weight all gravity 9.8 vector 0 0 -1\n"
               "fix move all motion damping 0 free_speed 0.2 safety 0.1\nrun 1500\n" +
               print_numbers("vz[1] f_move[3]"));
  // One step of gravity comes on top of the limit.
  EXPECT_NEAR(outcome.value("vz[1]"), -0.2, 9.8 * outcome.value("f_move[3]"));
}

// Pressed against a platen the grain is faster than the limit all the time, and free to be.
TEST(FreeSpeed, DoesNotSlowAGrainInContact)
{
  const std::string deck = material(7e6, 0.0) + grain(0, 0, 0.10005) + grain_size +
                           platen("top", 0.1 + radius - 1e-4) +
                           platen("bottom", 0.1 - radius + 1e-4);
  const std::string end = "run 300\n" + print_numbers("z[1]");
  const double limited =
      run_well(deck + "fix move all motion safety 0.01 free_speed 1e-6\n" + end).value("z[1]");
  const double free = run_well(deck + "fix move all motion safety 0.01\n" + end).value("z[1]");
  EXPECT_EQ(limited, free);
  EXPECT_NE(free, 0.10005);
}

// Where nothing reads velocities, two half kicks are made in one pass; that must not show in the
// motion.
TEST(FixMotion, GoesTheSameWayWhetherSomebodyLooksAtEachStepOrNot)
{
  const std::string deck = material(7e6, 0.5) + grain(0, 0, 0.1) + grain(0.0199, 0, 0.1) +
                           grain_size + velocity(0.0, 0.3, 0.1) +
                           "fix move all motion damping 0.3 safety 0.05 every 40\nthermo 10000\n";
  const std::string numbers = "x[1] y[1] z[1] vx[1] vy[1] vz[1] x[2] vy[2]";
  const std::string end = "run 313\n" + print_numbers(numbers + " f_move[5]");
  const Outcome alone = run_well(deck + end);
  const Outcome watched = run_well(deck + "fix look all print 1 \"a step\" screen no\n" + end);
  std::istringstream names(numbers);
  for (std::string name; names >> name;) EXPECT_EQ(alone.value(name), watched.value(name)) << name;
  EXPECT_NEAR(alone.value("f_move[5]"), watched.value("f_move[5]"),
              1e-12 * watched.value("f_move[5]"));
  EXPECT_NE(alone.value("vy[2]"), 0.0);
}
