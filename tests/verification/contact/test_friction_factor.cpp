// SPDX-License-Identifier: GPL-2.0-only
// A growth that minds the stress lowers the friction of contacts, not the coefficients of the deck.
#include "core/vec3.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;
using namespace encased_column::testing;

namespace {

/// Two grains, too heavy to be moved by what they do to each other, of which one slides past the
/// other at a friction of 0.5; with `growth` and `then`. Returns shear over normal force.
double sliding_friction(const std::string& growth, const std::string& then = "")
{
  std::string report;
  for (const std::string name : {"fx", "fy", "fz", "x", "y", "z"})
    for (const std::string grain : {"1", "2"})
      report += "variable " + name + grain + " equal " + name + "[" + grain + "]\nprint \"" + name +
                grain + " ${" + name + grain + "}\"\n";
  const Outcome found =
      run_deck(opening_deck("two_grains") +
               "unfix move\nset group all density 1e9\n"
               "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
               "fix top all servo/platen position top z 0.15 side side type 2\n"
               "fix bottom all servo/platen position bottom z 0.05 side side type 2\n"
               "fix move all motion damping 0 step 1e-5\n"
               "group slider id 2\nvelocity slider set 0 0.2 0 units box\n" +
               growth + "run 160\n" + then + report);
  EXPECT_EQ(found.exit_code, 0) << found.output;
  const auto vector = [&](const std::string& x, const std::string& y, const std::string& z) {
    return Vec3(found.value(x), found.value(y), found.value(z));
  };
  const Vec3 apart = vector("x2", "y2", "z2") - vector("x1", "y1", "z1");
  const Vec3 normal = apart / apart.norm(), force = vector("fx2", "fy2", "fz2");
  return (force - force.dot(normal) * normal).norm() / force.dot(normal);
}

/// The mean stress is 22 N x 19.8 mm / (3 x 0.785 l) = 185 Pa, between the target and twice it: at
/// each look, every 50 steps from the first on, friction is lowered.
const std::string growth =
    "fix grow all grow/radius from 1 stress 130 rest 10 platens top bottom side side\n";

}  // namespace

TEST(FrictionFactor, IsThatOfTheDeckWithoutAGrowth)
{
  EXPECT_NEAR(sliding_friction(""), 0.5, 1e-5);
}

TEST(FrictionFactor, LowersTheFrictionOfContactsAtEachLook)
{
  EXPECT_NEAR(sliding_friction(growth), 0.5 * std::pow(0.95, 4), 1e-5);
}

TEST(FrictionFactor, EndsWithTheFixThatGaveIt)
{
  EXPECT_NEAR(sliding_friction(growth, "unfix grow\nrun 40\n"), 0.5, 1e-5);
}
