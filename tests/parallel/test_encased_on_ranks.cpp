// SPDX-License-Identifier: GPL-2.0-only
// The shear of one encased specimen on 1, 2 and 4 ranks.
#include "restart/encased_deck.h"
#include "support/csv_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Specimens consolidated on one rank, each in its folder: see test_curves_on_ranks.cpp for why it
/// is not repeated. `cloth` are the words of the sleeve's material.
const TemporaryFolder& consolidated(const std::string& cloth)
{
  static std::map<std::string, TemporaryFolder> folders;
  const bool is_new = folders.count(cloth) == 0;
  const TemporaryFolder& folder = folders[cloth];
  if (is_new) {
    const Outcome outcome =
        run_deck(new_encased_specimen(encased_consolidation + "solve ratio average 1e-5\n"
                                                              "write_restart consolidated\n",
                                      cloth),
                 1, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  }
  return folder;
}

struct Shear {
  CsvTable history;
  Outcome outcome;
};

Shear shear_on(int ranks, const std::string& cloth)
{
  const TemporaryFolder folder;
  fs::copy(consolidated(cloth).path() / "consolidated", folder.path() / "consolidated");
  const Outcome outcome =
      run_deck(encased_specimen_of(
                   "consolidated",
                   history + "fix_modify bottom velocity 1e-6\nrun 1500\n"
                             "variable tension equal f_side[2]\nvariable volume equal f_side[9]\n"
                             "variable plastic equal f_side[16]\n"
                             "print \"tension ${tension}\"\nprint \"volume ${volume}\"\n"
                             "print \"plastic ${plastic}\"\n",
                   cloth),
               ranks, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  return {CsvTable(folder.path() / "history.csv"), outcome};
}

void expect_the_curves_of_one_rank(int ranks, const std::string& cloth = "")
{
  static std::map<std::string, Shear> on_one_rank;
  if (on_one_rank.count(cloth) == 0) on_one_rank.emplace(cloth, shear_on(1, cloth));
  const Shear& one = on_one_rank.at(cloth);
  const Shear many = shear_on(ranks, cloth);
  ASSERT_EQ(many.history.rows(), one.history.rows());
  const std::vector<double> top = one.history.column("stress_top [Pa]");
  const double peak = *std::max_element(top.begin(), top.end());
  EXPECT_GT(peak, 80e3);
  for (const char* name : {"stress_top [Pa]", "stress_bottom [Pa]"})
    for (std::size_t n = 0; n < one.history.rows(); ++n)
      EXPECT_NEAR(many.history.column(name)[n], one.history.column(name)[n], 0.01 * peak)
          << name << " row " << n;
  for (const char* name : {"porosity [-]", "porosity_less_overlap [-]", "coordination_number [-]",
                           "energy_elastic [J]", "stress_top [Pa]", "radius [m]"})
    EXPECT_NEAR(many.history.column(name)[0], one.history.column(name)[0],
                1e-9 * one.history.column(name)[0])
        << name;
  EXPECT_GT(one.outcome.value("tension"), 10.0);
  EXPECT_NEAR(many.outcome.value("tension") / one.outcome.value("tension"), 1.0, 0.01);
  EXPECT_NEAR(many.outcome.value("volume") / one.outcome.value("volume"), 1.0, 1e-4);
  EXPECT_NEAR(many.outcome.value("plastic"), one.outcome.value("plastic"),
              0.01 * one.outcome.value("plastic"));
  EXPECT_LT(many.history.column("energy_error [-]").back(), 0.01);
}

}  // namespace

TEST(EncasedOnRanks, TwoGiveTheCurvesOfOne)
{
  expect_the_curves_of_one_rank(2);
}

// Most facets wrinkle, some are stretched by more than half for good.
TEST(EncasedOnRanks, TwoGiveTheCurvesOfOneWithAClothThatWrinklesAndYields)
{
  expect_the_curves_of_one_rank(
      2, "tension_only yes strain_limit 5 strength 60 60 after_strength yield");
}

TEST(EncasedOnRanks, FourGiveTheCurvesOfOne)
{
  expect_the_curves_of_one_rank(4);
}
