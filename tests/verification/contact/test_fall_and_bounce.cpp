// SPDX-License-Identifier: GPL-2.0-only
// Free fall, bounces and collisions of grains.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace encased_column::testing;

namespace {

const std::string gravity = "fix weight all gravity 9.81 vector 0 0 -1\n";

/// Speed after over speed before a collision of which the dashpot cannot pull: the force of
/// x'' + 2 b w x' + w^2 x = 0 ends at w t sqrt(1 - b^2) = pi - 2 asin b.
double restitution(double beta)
{
  return std::exp(-beta / std::sqrt(1.0 - beta * beta) * (pi - 2.0 * std::asin(beta)));
}

}  // namespace

TEST(FreeFall, IsTheParabolaToRoundOff)
{
  const Outcome outcome =
      run_well(material(7e6, 0.5) + grain(0, 0, 0.15) + grain_size + gravity +
               "fix move all motion damping 0\nrun 400\n" + print_numbers("z[1] vz[1] dt*400"));
  const double t = outcome.value("dt*400");
  EXPECT_GT(t, 0.02);
  EXPECT_NEAR(outcome.value("z[1]"), 0.15 - 0.5 * 9.81 * t * t, 1e-14);
  EXPECT_NEAR(outcome.value("vz[1]"), -9.81 * t, 1e-13);
}

// The weight is that of the true mass, the inertia `factor` times as large.
TEST(FreeFall, IsSlowerByTheFactorOfDensityScaling)
{
  const Outcome outcome = run_well(material(7e6, 0.5) + grain(0, 0, 0.15) + grain_size + gravity +
                                   "fix move all motion damping 0 step 1e-3\nrun 400\n" +
                                   print_numbers("z[1] f_move[4]"));
  const double factor = outcome.value("f_move[4]");
  EXPECT_GT(factor, 10.0);
  EXPECT_NEAR(outcome.value("z[1]"), 0.15 - 0.5 * 9.81 / factor * 0.4 * 0.4, 1e-10);
}

// Every bounce leaves the part e of the speed: h_k = r + e^(2k) (h_0 - r). The grain is read at the
// tops of its flights, where a small error of time does no harm. A contact lasts 1/2000 of the
// flight, in which gravity acts too, and 140 steps: together within 0.3 % of the height a bounce.
TEST(Bounce, LeavesTheHeightThatTheDashpotsRestitutionSays)
{
  const double beta = 0.02, height = 0.11, step = 5e-7;
  const double e = restitution(beta);
  const double fall = std::sqrt(2.0 * (height - radius) / 9.81);
  std::string deck = material(7e8, 0.5, beta) + grain(0, 0, height) + grain_size + gravity +
                     platen("bottom", 0.0) + plain_motion(step) + "thermo 100000\n";
  double now = 0.0, top = fall, rise = fall;
  std::string tops;
  for (int k = 1; k <= 3; ++k) {
    top += k > 1 ? rise + rise * e : rise * e;  // down to the platen and up again
    rise *= e;
    const long steps = std::lround((top - now) / step);
    now = top;
    deck += "run " + std::to_string(steps) + "\nvariable top" + std::to_string(k) +
            " equal z[1]\nprint \"top" + std::to_string(k) + " ${top" + std::to_string(k) + "}\"\n";
  }
  const Outcome outcome = run_well(deck);
  for (int k = 1; k <= 3; ++k) {
    const double expected = std::pow(e, 2.0 * k) * (height - radius);
    EXPECT_NEAR(outcome.value("top" + std::to_string(k)) - radius, expected, 3e-3 * k * expected)
        << "bounce " << k;
  }
}

// The spring is then pressed in by the whole radius, but for the thousandth that keeps its
// direction.
TEST(Platen, PushesBackAGrainWhoseCenterIsBeyondIt)
{
  const Outcome outcome =
      run_well(material(7e6, 0.5) + grain(0, 0, -0.001) + grain_size + platen("bottom", 0.0) +
               plain_motion(1e-7) + "run 0\n" + print_numbers("fz[1]"));
  EXPECT_NEAR(outcome.value("fz[1]") / (pi * radius * 7e6 * radius), 0.999, 1e-12);
}

// Grains of 10 and 6 mm: k_n = pi r^2 E* / (R1 + R2) with the smaller radius.
TEST(Collision, HasTimeOverlapAndForceOfASpringBetweenTwoMasses)
{
  const double small = 0.006, speed = 0.1, modulus = 7e6, step = 1e-7;
  const double small_mass = density * 4.0 / 3.0 * pi * std::pow(small, 3);
  const double m_eff = mass * small_mass / (mass + small_mass);
  const double k_n = pi * small * small * modulus / (radius + small);
  const CsvTable track =
      track_of(material(modulus, 0.5) + grain(0, 0, 0.1) + grain(radius + small, 0, 0.1) +
               "set atom 1 diameter 0.02 density 2500\nset atom 2 diameter 0.012 density 2500\n" +
               "group first id 1\nvelocity first set 0.1 0 0 units box\n" + plain_motion(step) +
               "thermo 10000\n" + track_numbers("x[1] x[2] fx[2] step", 1) + "run 8000\n");
  const std::vector<double>&x_1 = track.column("x[1]"), &x_2 = track.column("x[2]"),
        &force = track.column("fx[2]"), &when = track.column("step");
  double overlap = 0.0, time = 0.0, largest = 0.0;
  for (std::size_t n = 0; n < track.rows(); ++n) {
    overlap = std::max(overlap, radius + small - (x_2[n] - x_1[n]));
    largest = std::max(largest, force[n]);
    if (force[n] > 0.0) time = when[n] * step;
  }
  EXPECT_NEAR(time, pi * std::sqrt(m_eff / k_n), 2.0 * step);
  EXPECT_NEAR(overlap, speed * std::sqrt(m_eff / k_n), 1e-6 * overlap);
  EXPECT_NEAR(largest, speed * std::sqrt(m_eff * k_n), 1e-6 * largest);
}

TEST(Collision, OfEqualGrainsWithDashpotHasTheRestitutionOfTheirPair)
{
  const double beta = 0.3;
  const Outcome outcome =
      run_well(material(7e6, 0.5, beta) + grain(-0.01, 0, 0.1) + grain(0.01, 0, 0.1) + grain_size +
               "group first id 1\nvelocity first set 0.1 0 0 units box\n" + plain_motion(1e-7) +
               "thermo 10000\nrun 10000\n" + print_numbers("vx[1] vx[2]"));
  const double e = restitution(beta);
  EXPECT_NEAR(outcome.value("vx[1]"), 0.05 * (1.0 - e), 1e-5);
  EXPECT_NEAR(outcome.value("vx[2]"), 0.05 * (1.0 + e), 1e-5);
}

// Only gravity works, and the walls are held. The upper one presses the grain by 1e-15 m at the
// start: over that elastic energy alone, round-off was a million.
TEST(FreeFall, ClosesTheAccountOfEnergyToRoundOff)
{
  for (const std::string step : {"stable", "1e-3"}) {
    const Outcome outcome =
        run_well(material(7e6, 0.5) + grain(0, 0, 0.15) + grain_size + gravity +
                 "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n" +
                 platen("top", 0.16 - 1e-15) + platen("bottom", 0.0) +
                 "fix move all motion damping 0 step " + step +
                 "\nfix history all specimen/history platens top bottom side side motion move "
                 "every 50\nrun 200\n" +
                 print_numbers("f_history[31] f_history[26] f_history[24]"));
    EXPECT_LT(outcome.value("f_history[31]"), 1e-12);
    EXPECT_GT(outcome.value("f_history[26]"), 1e-8) << "it falls";
    EXPECT_GT(outcome.value("f_history[24]"), 1e-8);
  }
}
