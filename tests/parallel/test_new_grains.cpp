// Grains that a fix of the host makes during a run, on one of two ranks.
#include "support/child_program.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// Grains of 8 mm put into the upper half while others lie below.
Outcome insert_above(const std::string& motion)
{
  return run_deck(
      opening_deck("empty_cylinder") +
          "create_atoms 1 single 0 0 0.01 units box\n"
          "set group all diameter 0.02 density 2500\n"
          "fix weight all gravity 9.81 vector 0 0 -1\n" +
          motion +
          "fix one all particletemplate/sphere 15485863 atom_type 1 density constant 2500 "
          "radius constant 0.004\n"
          "fix all_sizes all particledistribution/discrete 15485867 1 one 1.0\n"
          "region above cylinder z 0 0 0.02 0.14 0.16 units box\n"
          "fix put all insert/pack seed 32452843 distributiontemplate all_sizes "
          "insert_every 70 overlapcheck yes all_in yes region above "
          "particles_in_region 3\n"
          "run 200\nvariable n equal atoms\nprint \"grains ${n}\"\n"
          "variable stable equal f_move[3]\nprint \"stable ${stable}\"\n",
      2);
}

}  // namespace

TEST(NewGrains, OnOneRankAloneAreWeighedByAll)
{
  for (const char* motion : {"fix move all motion\n", "fix move all motion step 1e-3\n"}) {
    const Outcome outcome = insert_above(motion);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_GE(outcome.value("grains"), 4.0);
    EXPECT_GT(outcome.value("stable"), 0.0);
  }
}
