// SPDX-License-Identifier: GPL-2.0-only
// Grains that a fix of the host makes during a run, on one of two ranks.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

/// Grains of 8 mm put into the upper half in the middle of a run, one of 20 mm in the lower half.
Outcome insert_above(const std::string& motion)
{
  return run_deck(opening_deck("empty_cylinder") +
                      "create_atoms 1 single 0 0 0.01 units box\n"
                      "set group all diameter 0.02 density 2500\n"
                      "fix weight all gravity 9.81 vector 0 0 -1\n"
                      "fix move all motion every 1000 " +
                      motion +
                      "\n"
                      "fix one all particletemplate/sphere 15485863 atom_type 1 "
                      "density constant 2500 radius constant 0.004\n"
                      "fix sizes all particledistribution/discrete 15485867 1 one 1.0\n"
                      "region above cylinder z 0 0 0.02 0.14 0.16 units box\n"
                      "run 10\n"
                      "fix put all insert/pack seed 32452843 distributiontemplate sizes "
                      "insert_every 70 overlapcheck yes all_in yes region above "
                      "particles_in_region 3\n"
                      "run 100\nvariable n equal atoms\nprint \"grains ${n}\"\n"
                      "variable stable equal f_move[3]\nprint \"stable ${stable}\"\n"
                      "variable factor equal f_move[4]\nprint \"factor ${factor}\"\n",
                  2);
}

const double r = 0.004, pi = std::acos(-1.0), mass = 4.0 / 3.0 * pi * r * r * r * 2500.0;
/// Of a contact with something flat: pi r E*, and 5/2 of it against rotation.
const double stiffness = 2.5 * pi * r * 7e6;

}  // namespace

// The small grains bring the step down to theirs.
TEST(NewGrains, OnOneRankAloneShortenTheStepOfAll)
{
  const Outcome outcome = insert_above("safety 0.8");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_GE(outcome.value("grains"), 4.0);
  EXPECT_NEAR(outcome.value("stable") / (0.8 * std::sqrt(mass / stiffness)), 1.0, 1e-12);
}

TEST(NewGrains, OnOneRankAloneGetTheirInertia)
{
  const Outcome outcome = insert_above("step 1e-3 safety 0.8");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_GE(outcome.value("grains"), 4.0);
  const double inertia = stiffness * std::pow(1e-3 / 0.8, 2);
  EXPECT_NEAR(outcome.value("factor") / (inertia / mass), 1.0, 1e-12);
}
