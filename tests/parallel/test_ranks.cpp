// SPDX-License-Identifier: GPL-2.0-only
// The plain triaxial deck on several ranks. While the grains grow and first meet, every rank count
// gives the same numbers to round-off. A packing under growth is chaotic, so later only sums over
// many grains could agree, and a hundred grains are not many: there the test asks that the specimen
// still obeys its balances.
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

struct Growth {
  std::string gradation;
  double places, squares, unbalanced;
};

/// The deck up to its first run, cut short after the first contacts.
Growth grow_on(int ranks)
{
  const TemporaryFolder folder;
  const std::string deck = plain_triaxial_deck();
  const std::size_t end = deck.find("\nif \"${stress_packing} == 0\" then \"run ");
  EXPECT_NE(end, std::string::npos);
  const Outcome outcome = run_small_triaxial(folder.path(), ranks, deck.substr(0, end) + R"(
run 2800
variable place atom x+2*y+3*z
variable square atom vx^2+vy^2+vz^2
compute places all reduce sum v_place
compute squares all reduce sum v_square
variable places equal c_places
variable squares equal c_squares
variable unbalanced equal f_move[1]
thermo_style custom step c_places c_squares
run 0
print "places ${places}"
print "squares ${squares}"
print "unbalanced ${unbalanced}"
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  return {read_text(folder.path() / "gradation.csv"), outcome.value("places"),
          outcome.value("squares"), outcome.value("unbalanced")};
}

}  // namespace

TEST(Ranks, GrowTheSamePackingGrainByGrain)
{
  const Growth expected = grow_on(1);
  ASSERT_GT(expected.squares, 0.0);
  ASSERT_LT(expected.unbalanced, 1.0);  // grains do meet
  for (const int ranks : {2, 4}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const Growth found = grow_on(ranks);
    EXPECT_EQ(found.gradation, expected.gradation);
    EXPECT_NEAR(found.places, expected.places, 1e-10 * std::abs(expected.places));
    EXPECT_NEAR(found.squares, expected.squares, 1e-6 * expected.squares);
    EXPECT_NEAR(found.unbalanced, expected.unbalanced, 1e-6);
  }
}

TEST(Ranks, TwoHoldTheConfiningStressAndCloseTheEnergyBalance)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_small_triaxial(folder.path(), 2);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable history(folder.path() / "history.csv");
  for (const double stress : history.column("confining_stress [Pa]"))
    EXPECT_NEAR(stress, 50e3, 500.0);
  for (const double error : history.column("energy_error [-]")) EXPECT_LT(std::abs(error), 0.02);
}
