// SPDX-License-Identifier: GPL-2.0-only
// Ends of a sleeve that move, through the deck.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

/// A stack of grains that the upper platen shortens by 0.2 mm in a wider sleeve, and what is then
/// read: force and stress on the platen, forces of the supports on the sleeve's ends, its volume.
Outcome shortened(const std::string& top_end)
{
  return run_deck(
      opening_deck("grain_stack") +
      "fix side all mesh/surface/shell cylinder 0.03 0 0.08 edge 0.01 type 2 platens top bottom "
      "modulus 5e6 poisson 0.3 thickness 0.002 density 2000 top_end " +
      top_end +
      "\nfix top all servo/platen position top z 0.08 side side type 2\n"
      "fix bottom all servo/platen position bottom z 0 side side type 2\n"
      "fix move all motion step 1.0\nrun 0\nfix_modify top velocity 2e-7\nrun 1000\n"
      "fix_modify top hold\nrun 1000\n"
      "variable force equal f_top[2]\nvariable stress equal f_top[1]\nvariable up equal f_side[6]\n"
      "variable down equal f_side[7]\nvariable volume equal f_side[9]\n"
      "print \"force ${force}\"\nprint \"stress ${stress}\"\nprint \"up ${up}\"\n"
      "print \"down ${down}\"\nprint \"volume ${volume}\"\n");
}

const double section = std::acos(-1.0) * 0.03 * 0.03;

}  // namespace

// The stack has four columns of springs, 27 489 N/m each.
TEST(SleeveEnds, PlatenFindsItsSectionWhereTheEndHasMovedWithIt)
{
  const Outcome outcome = shortened("platen");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NEAR(outcome.value("force"), 4.0 * 27489.0 * 2e-4, 0.1);
  EXPECT_NEAR(outcome.value("force") / outcome.value("stress") / section, 1.0, 0.03);
  EXPECT_NEAR(outcome.value("volume") / (section * 0.0798), 1.0, 0.03);
}

// A plate of width 2 pi R whose ends stay round: between E t and E t / (1 - nu^2) times the strain.
TEST(SleeveEnds, PlatenPressesTheSleeveAsAPlateInCompression)
{
  const Outcome outcome = shortened("platen");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const double uniaxial = 5e6 * 0.002 * 2.0 * std::acos(-1.0) * 0.03 * 2e-4 / 0.08;
  EXPECT_LT(outcome.value("up"), -0.97 * uniaxial);
  EXPECT_GT(outcome.value("up"), -1.1 * uniaxial);
  EXPECT_NEAR(outcome.value("up") + outcome.value("down"), 0.0, 1e-3 * uniaxial);
}

TEST(SleeveEnds, AHeldEndStaysWhereThePlatenGoesIn)
{
  const Outcome outcome = shortened("held");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NEAR(outcome.value("up"), 0.0, 1e-9);
  EXPECT_NEAR(outcome.value("force") / outcome.value("stress") / section, 1.0, 0.03);
}
