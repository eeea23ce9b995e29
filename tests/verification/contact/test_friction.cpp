// SPDX-License-Identifier: GPL-2.0-only
// Sliding and rolling on a platen.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

const double g = 9.81;
const std::string gravity = "fix weight all gravity 9.81 vector 0 0 -1\n";

/// A grain that lies on the platen with its weight, moving along x.
std::string lying_grain(double modulus, double friction, double beta_s, double speed)
{
  const double sunk = mass * g / (pi * radius * modulus);
  return material(modulus, friction, 0.0, beta_s) + grain(-0.04, 0, radius - sunk) + grain_size +
         gravity + platen("bottom", 0.0) + velocity(speed, 0, 0) + "thermo 100000\n";
}

}  // namespace

// Friction takes speed and gives spin until both fit, at 5/7 of the speed, after t = 2 u0 / (7 mu
// g); the dashpot quietens the shear spring that is left. Half the overlap is missing in the lever
// arm: 2e-6.
TEST(Sliding, EndsInRollingAtFiveSeventhsOfTheSpeed)
{
  const double u0 = 0.2, mu = 0.3;
  const double until = 2.0 * u0 / (7.0 * mu * g);
  const double step = 2e-6;
  const Outcome outcome = run_well(lying_grain(7e7, mu, 0.3, u0) + plain_motion(step) + "run " +
                                   std::to_string(std::lround(1.5 * until / step)) + "\n" +
                                   print_numbers("vx[1] omegay[1] vz[1]"));
  EXPECT_NEAR(outcome.value("vx[1]"), 5.0 / 7.0 * u0, 1e-5 * u0);
  EXPECT_NEAR(outcome.value("omegay[1]") * radius, 5.0 / 7.0 * u0, 1e-5 * u0);
}

TEST(Sliding, IsSlowedByFrictionTimesGravityUntilThen)
{
  const double u0 = 0.2, mu = 0.3, t = 0.01, step = 2e-6;
  const Outcome outcome = run_well(lying_grain(7e7, mu, 0.0, u0) + plain_motion(step) +
                                   "run 5000\n" + print_numbers("vx[1] omegay[1]"));
  EXPECT_NEAR(outcome.value("vx[1]"), u0 - mu * g * t, 2e-3 * mu * g * t);
  EXPECT_NEAR(outcome.value("omegay[1]"), 2.5 * mu * g * t / radius,
              2e-3 * 2.5 * mu * g * t / radius);
}

// While it slides all through the impact, impulses are in the ratio mu. Half the overlap is missing
// in the lever arm: up to 2e-4 of the spin.
TEST(ObliqueImpact, ThatSlidesAllThroughChangesSpeedAndSpinByFrictionTimesImpulse)
{
  for (const double beta : {0.0, 0.1}) {
    const double mu = 0.2, vx = 1.0, vz = 0.2;
    const double e = std::exp(-beta / std::sqrt(1.0 - beta * beta) * (pi - 2.0 * std::asin(beta)));
    const Outcome outcome =
        run_well(material(7e8, mu, beta) + grain(0, 0, radius + 1e-5) + grain_size +
                 platen("bottom", 0.0) + velocity(vx, 0, -vz) + plain_motion(1e-7) +
                 "thermo 10000\nrun 4000\n" + print_numbers("vx[1] vz[1] omegay[1]"));
    EXPECT_NEAR(outcome.value("vz[1]"), e * vz, 1e-3 * vz);
    const double impulse = vz + outcome.value("vz[1]");  // per mass
    EXPECT_NEAR(outcome.value("vx[1]"), vx - mu * impulse, 1e-3 * mu * impulse);
    const double spin = 2.5 * mu * impulse / radius;
    EXPECT_NEAR(outcome.value("omegay[1]"), spin, 2e-3 * spin);
  }
}

// A torque mu_r m g r against rolling slows a rolling ball by (5/7) mu_r g; it comes to rest after
// 7 u^2 / (10 mu_r g), when the platen's rolling resistance has taken 7/10 m u^2.
class RollingResistance : public ::testing::Test {
 protected:
  static constexpr double speed = 0.2, mu_r = 0.1;

  /// A ball that rolls along the platen inside walls it does not reach, with its energies in the
  /// history.
  static std::string deck()
  {
    const double modulus = 7e7;
    const double sunk = mass * g / (pi * radius * modulus);
    return material(modulus, 0.5, 0.0, 0.3) +
           "fix rollf all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 "
           "0.1\npair_style gran model linear tangential history rolling_friction epsd2\n"
           "pair_coeff * *\n" +
           grain(-0.03, 0, radius - sunk) + grain_size + gravity +
           "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
           "fix top all servo/platen position top z 0.2 area 1 type 2\n"
           "fix bottom all servo/platen position bottom z 0 area 1 type 2\n" +
           velocity(speed, 0, 0) + "set group all omegay " + digits(speed / radius) + "\n" +
           "fix move all motion damping 0 safety 0.4 every 10\n"
           "fix history all specimen/history platens top bottom side side motion move every 10\n"
           "thermo 100000\n";
  }
};

TEST_F(RollingResistance, SlowsARollingBallByFiveSeventhsOfItsCoefficientTimesGravity)
{
  const Outcome outcome = run_well(deck() + "run 8000\n" + print_numbers("vx[1] dt*8000"));
  const double t = outcome.value("dt*8000");
  const double slowing = 5.0 / 7.0 * mu_r * g * t;
  EXPECT_GT(slowing, 0.1 * speed);
  EXPECT_LT(slowing, 0.9 * speed);
  EXPECT_NEAR(outcome.value("vx[1]"), speed - slowing, 0.01 * slowing);
}

TEST_F(RollingResistance, StopsItWhereItsEnergyIsSpent)
{
  const Outcome outcome =
      run_well(deck() + "run 24000\n" + print_numbers("vx[1] x[1] f_history[28]"));
  const double way = 0.7 * speed * speed / (mu_r * g);
  EXPECT_NEAR(outcome.value("vx[1]"), 0.0, 0.01 * speed);
  EXPECT_NEAR(outcome.value("x[1]"), -0.03 + way, 0.01 * way);
  EXPECT_NEAR(outcome.value("f_history[28]"), 0.7 * mass * speed * speed,
              0.01 * 0.7 * mass * speed * speed);
}
