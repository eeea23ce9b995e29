// SPDX-License-Identifier: GPL-2.0-only
// The first screen of a page: numbers, sentence and figure of closed forms beside the laboratory.
#include "closed_form_case.h"
#include "drawing/figures.h"
#include "support/child_program.h"
#include "tables/agreement.h"
#include "tables/result_table.h"
#include "tables/run_variables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// A plain and an encased test at 50 kPa; from 0.1 % strain on 146 kPa, and 300 kPa at the bottom
/// with 900 kPa at the top.
class AgreementTest : public ::testing::Test {
 protected:
  void SetUp() override
  {
    write_case(series_.path() / "plain", "plain");
    write_case(series_.path() / "encased", "encased");
    runs_ = read_case_runs({series_.path()});
    sets_ = evaluate(runs_.runs, {}, targets_);
  }
  const Targets targets_{fs::path(ENCASE_SOURCE) / "postprocess/targets.csv"};
  std::vector<SetResult> sets_;
  std::vector<CaseRun> own_;

 private:
  TemporaryFolder series_;
  CaseRuns runs_;
};

AgreementNumber number(const std::string& quantity, double ratio)
{
  return {"plain", quantity, "", "-", ratio, 1.0, 0.15, true};
}

}  // namespace

// Tables 2 and 5: peaks of 154.3 and 763.7 kPa at 50 kPa, E50 of 10.9 and 5.7 MPa. The curves rise
// to their level within 0.1 %: E50 is half of it over 0.05 %.
TEST_F(AgreementTest, TellsFoundOverLaboratory)
{
  const std::vector<AgreementNumber> numbers = agreement_numbers(sets_, targets_);
  ASSERT_EQ(numbers.size(), 4u);
  const std::vector<std::string> tests{"plain", "plain", "encased", "encased"};
  const std::vector<std::string> names{"E50 at 50 kPa", "peak q at 50 kPa", "E50 at 50 kPa",
                                       "peak q at 50 kPa"};
  const std::vector<double> found{146.0, 146.0, 300.0, 300.0};
  const std::vector<double> laboratory{10.9, 154.3, 5.7, 763.7};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(numbers[i].tests, tests[i]);
    EXPECT_EQ(numbers[i].name(), names[i]);
    EXPECT_NEAR(numbers[i].found, found[i], 0.05);
    EXPECT_DOUBLE_EQ(numbers[i].published, laboratory[i]);
    EXPECT_NEAR(numbers[i].allowed, 0.15 * laboratory[i], 1e-9);
    EXPECT_TRUE(numbers[i].of_laboratory);
  }
  EXPECT_EQ(agreement_sentence(numbers),
            "Met within 15 % of the laboratory: 1 of 4 values; farthest off: E50 at 50 kPa "
            "(encased), 52.63 times it.");
}

// Gravel of one's own has no laboratory beside it, neither in numbers nor in the figure.
TEST_F(AgreementTest, LeavesOutWhatReproducesNothingOfTheStudy)
{
  for (SetResult& set : sets_)
    for (TestResult& test : set.tests) own_.push_back(*test.run);
  for (CaseRun& run : own_) run.reproduces.clear();
  const std::vector<SetResult> own = evaluate(own_, {}, targets_);
  EXPECT_TRUE(agreement_numbers(own, targets_).empty());
  for (const SetResult& set : own)
    for (const ResultRow& row : result_rows(set, targets_)) {
      EXPECT_FALSE(row.published.laboratory) << row.quantity;
      EXPECT_FALSE(row.published.model) << row.quantity;
    }
  const std::vector<Figure> figures = agreement_figures(own, targets_);
  ASSERT_EQ(figures.size(), 1u);
  for (const Panel& panel : figures.front().panels)
    for (const Series& series : panel.series)
      EXPECT_EQ(series.label.find("laboratory"), std::string::npos) << series.label;
}

TEST(AgreementSentence, CallsHalfAsFarOffAsTwice)
{
  EXPECT_EQ(agreement_sentence({number("a", 1.9), number("b", 0.5), number("c", 1.1)}),
            "Met within 15 % of the laboratory: 1 of 3 values; farthest off: b (plain), 0.50 "
            "times it.");
  EXPECT_EQ(agreement_sentence({number("a", 0.9), number("b", 1.05)}),
            "Met within 15 % of the laboratory: 2 of 2 values.");
  EXPECT_EQ(agreement_sentence({}),
            "The laboratory has no values beside which these tests could stand.");
}

TEST_F(AgreementTest, ShowsBothPlatensOfBothTestsAndTheLaboratory)
{
  const std::vector<Figure> figures = agreement_figures(sets_, targets_);
  ASSERT_EQ(figures.size(), 1u);
  ASSERT_EQ(figures.front().panels.size(), 2u);
  const Panel& encased = figures.front().panels.back();
  EXPECT_EQ(encased.title, "Encased triaxial tests");
  std::vector<double> ends;  // of curves, then of the laboratory's line and its disc
  std::vector<Stroke> strokes;
  for (const Series& series : encased.series) {
    if (series.color == grey) continue;  // of the legend
    ends.push_back(series.y.back());
    strokes.push_back(series.stroke);
  }
  const std::vector<double> expected{300.0, 900.0, 763.7, 0.5 * 763.7};
  ASSERT_EQ(ends.size(), expected.size());
  for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], expected[i], 1e-6) << i;
  EXPECT_EQ(strokes, (std::vector<Stroke>{Stroke::solid, Stroke::dashed, Stroke::dash_dotted,
                                          Stroke::none}));
  // Half of 763.7 kPa over 5.7 MPa.
  EXPECT_NEAR(encased.series.back().x.front(), 100.0 * 0.5 * 763.7e3 / 5.7e6, 1e-9);
}

TEST(RunVariables, StandOnceWithUnitsWhereRunsShareThem)
{
  CaseRun one, two;
  one.variables = {{"sigma3", 50e3}, {"modulus", 140e6}, {"mu", 0.38}, {"radius", 0.05}};
  two.variables = {{"sigma3", 100e3}, {"modulus", 140e6}, {"mu", 0.5}};
  one.resolution = two.resolution = "quick";
  one.parameters = "laboratory";
  EXPECT_EQ(run_variables({&one, &two}),
            "σ₃ 50 / 100 kPa, E* 140 MPa, μ 0.38 / 0.5, radius 50 mm, set laboratory, resolution "
            "quick");
}

// Of resolution quick: 8.5e-7 m per step are 0.85 mm in 1000 steps; 0.40 and 0.057 looser.
TEST(RunVariables, AreThoseTheRunsWentWith)
{
  CaseRun run;
  run.variables = {{"porosity", 0.40}, {"generation", 0.457}, {"rate", 0.0}, {"rate_here", 8.5e-7}};
  EXPECT_EQ(run_variables({&run}), "porosity 0.457, rate 0.85 mm per 1000 steps");
  run.variables["rate"] = 1.2e-6;  // asked for
  run.variables.erase("generation");
  EXPECT_EQ(run_variables({&run}), "porosity 0.4, rate 1.2 mm per 1000 steps");
}

// A deck computes some of its variables: the run's own table has them, case.json what was asked.
TEST(RunVariables, AreReadWithThoseTheDeckComputed)
{
  const TemporaryFolder folder;
  const fs::path plain = folder.path() / "plain";
  write_case(plain, "plain");
  describe_case(plain, "plain", R"("sigma3": 50000, "porosity": 0.4, "rate": 0)");
  std::ofstream(plain / "variables.csv")
      << "name,style,value\nporosity,index,\"0.4\"\nrate,index,\"0\"\nrate_here,equal,\"8.5e-07\"\n"
         "generation,equal,\"0.457\"\nmu,equal,\"none\"\n";
  const CaseRuns found = read_case_runs({plain});
  ASSERT_EQ(found.runs.size(), 1u);
  EXPECT_EQ(run_variables({&found.runs.front()}),
            "σ₃ 50 kPa, porosity 0.457, rate 0.85 mm per 1000 steps");
}
