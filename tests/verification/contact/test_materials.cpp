// SPDX-License-Identifier: GPL-2.0-only
// Which micro-parameters a contact takes.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// Moduli of the pairs 11 12 13 22 23 33 [Pa].
const double e_11 = 1e6, e_12 = 2e6, e_13 = 3e6, e_22 = 4e6, e_23 = 5e6, e_33 = 6e6;

const std::string three_types = R"(
units          si
atom_style     granular
atom_modify    map array
boundary       f f f
newton         off
communicate    single vel yes
region         box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box     3 box
neighbor       0.0005 bin
fix            modulus all property/global contactModulus peratomtypepair 3 1e6 2e6 3e6 2e6 4e6 5e6 3e6 5e6 6e6
fix            kappa all property/global stiffnessRatio peratomtypepair 3 1 1 1 1 1 1 1 1 1
fix            friction all property/global coefficientFriction peratomtypepair 3 0 0 0 0 0 0 0 0 0
pair_style     gran model linear tangential history
pair_coeff     * *
timestep       1e-6
)";

/// Force between two grains that overlap by 0.2 mm, or a grain and a wall.
double pair_force(double modulus)
{
  return pi * radius * radius * modulus / (2.0 * radius) * 2e-4;
}
double wall_force(double modulus)
{
  return pi * radius * modulus * 2e-4;
}

}  // namespace

TEST(Materials, EveryPairOfTypesHasItsOwnModulus)
{
  // Six pairs side by side, numbered 1 2, 3 4, ...
  const int types[6][2] = {{1, 1}, {1, 2}, {1, 3}, {2, 2}, {2, 3}, {3, 3}};
  std::string deck = three_types, list;
  for (int n = 0; n < 6; ++n)
    for (int k = 0; k < 2; ++k)
      deck += "create_atoms " + std::to_string(types[n][k]) + " single " + digits(k * 0.0198) +
              " " + digits(-0.06 + 0.022 * n) + " 0 units box\n";
  for (int n = 0; n < 6; ++n) list += "fx[" + std::to_string(2 * n + 2) + "] ";
  const Outcome outcome =
      run_well(deck + grain_size + "fix move all nve/sphere\nrun 0\n" + print_numbers(list));
  const double moduli[6] = {e_11, e_12, e_13, e_22, e_23, e_33};
  for (int n = 0; n < 6; ++n)
    EXPECT_NEAR(outcome.value("fx[" + std::to_string(2 * n + 2) + "]"), pair_force(moduli[n]), 1e-9)
        << types[n][0] << " " << types[n][1];
}

TEST(Materials, AWallTakesThePropertiesOfItsTypeWithThoseOfTheGrain)
{
  const std::string grains =
      "create_atoms 1 single 0 0 0 units box\ncreate_atoms 2 single 0.05 0 0 units box\n" +
      grain_size + "fix move all nve/sphere\n";
  const Outcome platens =
      run_well(three_types + grains +
               "fix top all servo/platen position top z 0.0098 area 1 type 3\nrun 0\n" +
               print_numbers("fz[1] fz[2] f_top[2]"));
  EXPECT_NEAR(platens.value("fz[1]"), -wall_force(e_13), 1e-9);
  EXPECT_NEAR(platens.value("fz[2]"), -wall_force(e_23), 1e-9);
  EXPECT_NEAR(platens.value("f_top[2]"), wall_force(e_13) + wall_force(e_23), 1e-9);

  const Outcome host = run_well(three_types + grains +
                                "fix floor all wall/gran model linear tangential history primitive "
                                "type 3 zplane -0.0098\nrun 0\n" +
                                print_numbers("fz[1] fz[2]"));
  EXPECT_NEAR(host.value("fz[1]"), wall_force(e_13), 1e-9);
  EXPECT_NEAR(host.value("fz[2]"), wall_force(e_23), 1e-9);
}

TEST(Clear, LeavesOurStylesToTheNextPartOfADeck)
{
  const std::string part =
      opening_deck("two_grains") +
      "unfix move\nfix move all motion\nfix top all servo/platen position top z "
      "0.109 area 1 type 2\nrun 20\n";
  const Outcome once = run_well(part + print_numbers("x[1] x[2] f_top[2]"));
  const Outcome twice = run_well(part + "clear\n" + part + print_numbers("x[1] x[2] f_top[2]"));
  for (const char* name : {"x[1]", "x[2]", "f_top[2]"}) {
    EXPECT_FALSE(std::isnan(once.value(name)));
    EXPECT_EQ(twice.value(name), once.value(name)) << name;
  }
}
