// SPDX-License-Identifier: GPL-2.0-only
// What a case costs is known before it runs: beside the numbers that runs of the decks printed.
#include "runner/case_shape.h"

#include "runner/case_list.h"
#include "runner/deck_text.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// The study's density, whatever the decks take by default.
const std::vector<std::string> study_packing{"parameters=study"};

/// What `look` finds in the plan of a case of ours.
template <typename Look>
auto in_ours(const std::string& id, const std::string& resolution, std::vector<std::string> set,
             const Look& look)
{
  Places places;
  places.inputs = fs::path(ENCASE_SOURCE) / "input_scripts";
  RunOptions options;
  options.cases = {id};
  options.resolution = resolution;
  options.set = std::move(set);
  DeckCatalogue decks(places.inputs);
  return look(chosen_cases(read_catalogue(places, options), decks, options).front()).value();
}

CaseSize size_of_ours(const std::string& id, const std::string& resolution,
                      const std::vector<std::string>& set = study_packing)
{
  return in_ours(id, resolution, set, expected_size);
}

/// Speed of one platen towards the other, and limit for grains that touch nothing [m per step].
std::array<double, 2> speeds_of_ours(const std::string& id, const std::string& resolution,
                                     const std::vector<std::string>& set)
{
  const auto number = [&](const char* name) {
    return in_ours(id, resolution, set, [&](const CasePlan& plan) {
      return DeckText(*plan.deck, plan.asked).number(name);
    });
  };
  return {number("approach"), number("speed_limit")};
}

void expect_speeds(const std::array<double, 2>& found, const std::array<double, 2>& expected)
{
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]);
}

CaseShape shape_with_steps(double limit, double strain_end)
{
  CaseShape shape;
  shape.gradation = {{0.005, 0.010, 100.0}};
  shape.radius = 0.05;
  shape.height = 0.2;
  shape.porosity = 0.4;
  shape.limit = limit;
  shape.strain_end = strain_end;
  shape.rate = 1e-6;
  return shape;
}

}  // namespace

// create_packing printed 3 993, 9 054 and 54 412 grains; it rounds each class.
TEST(CaseSize, HasTheGrainsThatArePacked)
{
  EXPECT_NEAR(size_of_ours("plain_050", "quick").grains, 3993.0, 2.0);
  EXPECT_NEAR(size_of_ours("plain_050", "standard").grains, 9054.0, 2.0);
  EXPECT_NEAR(size_of_ours("encased_050", "paper").grains, 54412.0, 2.0);
}

// Void ratios 0.5049 / 0.4951 and 0.3806 / 0.6194 of packing_limits.csv: in the middle porosity
// 0.4497, which the page of the decks has; solids go with 1 - n.
TEST(CaseSize, FollowsTheRelativeDensity)
{
  const double dense = size_of_ours("plain_050", "quick").grains;
  const std::vector<std::string> half{"parameters=study", "relative_density=0.5", "mu=0.7",
                                      "mu_r=0.5"};
  EXPECT_NEAR(size_of_ours("plain_050", "quick", half).grains / dense, (1.0 - 0.4497) / 0.71, 1e-3);
}

// 0.05 x 0.2 / 1e-6 m are 10 000 steps more than none.
TEST(CaseSize, HasTheStepsOfShear)
{
  EXPECT_NEAR(case_size(shape_with_steps(1e-5, 0.06)).steps() -
                  case_size(shape_with_steps(1e-5, 0.01)).steps(),
              10'000.0, 1e-6);
  EXPECT_GT(case_size(shape_with_steps(1e-5, 0.01)).steps(),
            case_size(shape_with_steps(1e-3, 0.01)).steps());
}

// Columns of set study at `paper`: that of S1 began its shear at step 14 600, after 8 000 of
// consolidation, and ended at 39 600; that of 40 % relative density at 37 000. Shear itself is 30
// mm at 1.2e-6 m per step.
TEST(CaseSize, HasTheStepsOfAColumnOfTheStudy)
{
  const CaseSize column = size_of_ours("study_column", "paper");
  EXPECT_NEAR(column.steps_after - 25'000.0, 8'000.0, 800.0);
  EXPECT_NEAR(column.steps(), 39'600.0, 0.05 * 39'600.0);
  EXPECT_NEAR(size_of_ours("study_column_dr40", "paper").steps(), 37'000.0, 0.10 * 37'000.0);
}

// The 5 796 facets of the page of the benchmarks, and the 2 496 in the files of a run of the set
// laboratory at quick.
TEST(CaseSize, CountsTheSleeve)
{
  const CaseSize plain = size_of_ours("plain_050", "quick");
  const CaseSize fine = size_of_ours("encased_050", "quick", {"parameters=study", "facet=5e-3"});
  const CaseSize usual = size_of_ours("encased_050", "quick", {"parameters=laboratory"});
  const CaseSize loose = size_of_ours("plain_050", "quick", {"parameters=laboratory"});
  for (const auto& [encased, without, facets] :
       {std::tuple(fine, plain, 5796.0), std::tuple(usual, loose, 2496.0)})
    EXPECT_NEAR((encased.work / encased.grains -
                 without.work / without.grains / without.steps() * encased.steps()) *
                    encased.grains / (2.0 * encased.steps_after + 0.3 * encased.steps_before),
                facets, 1.0);
  // What a grain takes, measured in ns a step: 168 and 273 in speed/packing.lmp at porosity 0.45
  // and 0.29, 124 in the shear of plain_100 at `quick`, set laboratory.
  EXPECT_NEAR(plain.work / plain.grains / plain.steps(), 273.0 / 168.0, 0.03);
  EXPECT_NEAR(loose.work / loose.grains / loose.steps(), 124.0 / 168.0, 0.02);
  EXPECT_GT(fine.bytes, plain.bytes);
}

// Inertial numbers go with the rate over sqrt(sigma3): four times the stress, twice the speed. The
// page of the variables has 9.0e-7 and 6.5e-7 m per step at 50 kPa.
TEST(Decks, MoveAtOneInertialNumberWhereTheRateIsZero)
{
  const std::string laboratory = "parameters=laboratory";
  for (const std::string id : {"plain_050", "encased_050", "column"}) {
    expect_speeds(speeds_of_ours(id, "quick", {laboratory}), {9.0e-7, 1.8e-6});
    expect_speeds(speeds_of_ours(id, "quick", {laboratory, "sigma3=200e3"}), {1.8e-6, 3.6e-6});
    expect_speeds(speeds_of_ours(id, "paper", {laboratory, "moving=2"}), {6.5e-7, 1.3e-6});
    expect_speeds(speeds_of_ours(id, "standard", {laboratory, "rate=1e-6", "sigma3=200e3"}),
                  {1.0e-6, 2.0e-6});
    expect_speeds(speeds_of_ours(id, "standard", {laboratory, "free_speed=4e-6"}),
                  {6.5e-7, 4.0e-6});
  }
}

TEST(CaseSize, IsUnknownWhereTheDeckPacksNothing)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "own.lmp") << "variable rate index 3\n";
  const Deck deck = read_deck("own", folder.path() / "own.lmp", folder.path());
  EXPECT_FALSE(expected_size({{}, &deck, {}, {{"rate", "3"}}}));
}

TEST(DeckText, FindsWordsThroughVariablesIncludesAndContinuedLines)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "fine.lmp") << "variable gap equal 2e-3\n";
  std::ofstream(folder.path() / "own.lmp") << "variable kind index coarse\n"
                                              "variable wide index 0.2  # [m]\n"
                                              "include ${common}/${kind}.lmp\n"
                                              "variable clear equal 2*(v_wide-${gap})\n"
                                              "if \"${wide} > 0\" then &\n"
                                              "  \"place radius ${clear} &\n"
                                              "  kind ${kind}\"\n"
                                              "place height ${unknown}\n";
  const Deck deck = read_deck("own", folder.path() / "own.lmp", folder.path());
  const DeckText text(deck, {{"kind", "fine"}, {"wide", "0.1"}});
  EXPECT_DOUBLE_EQ(text.number("clear").value(), 0.196);
  const std::vector<std::string> words = text.words("place", "kind");
  ASSERT_EQ(words.size(), 4u);
  EXPECT_EQ(words[3], "fine");
  EXPECT_DOUBLE_EQ(formula_value(words[1]).value(), 0.196);
  EXPECT_EQ(text.words("place", "height").size(), 2u);
  EXPECT_FALSE(text.number("unknown"));
  EXPECT_TRUE(text.words("place", "depth").empty());
}

TEST(DeckText, ReckonsAsDecksDo)
{
  EXPECT_DOUBLE_EQ(formula_value("1+2*3").value(), 7.0);
  EXPECT_DOUBLE_EQ(formula_value("-(1-3)/4").value(), 0.5);
  EXPECT_DOUBLE_EQ(formula_value("1.2e-3").value(), 1.2e-3);
  EXPECT_DOUBLE_EQ(formula_value("(-1==1)+2*(3>=3&&1!=2)").value(), 2.0);
  EXPECT_DOUBLE_EQ(formula_value("ceil(2.1)+floor(-0.5)+2^3").value(), 10.0);
  for (const char* bad : {"", "a", "1+", "(1", "1/0", "1 2", "nan", "inf", "0x", "random(0,1,3)"})
    EXPECT_FALSE(formula_value(bad)) << bad;
}
