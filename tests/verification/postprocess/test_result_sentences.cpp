// SPDX-License-Identifier: GPL-2.0-only
// The three sentences at the end of a run, from histories in closed form and a table of published
// values written here.
#include "closed_form_case.h"
#include "support/child_program.h"
#include "tables/agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

class ResultSentences : public ::testing::Test {
 protected:
  /// Plain tests at 50 and 100 kPa, q 146 and 292 kPa times `strength`; the porosity is 0.34.
  void make_tests(double strength = 1.0)
  {
    for (const int factor : {1, 2}) {
      const std::string stress = std::to_string(50 * factor);
      const fs::path run = series_.path() / ("test_" + stress);
      write_case(run, "plain", true, factor, strength);
      describe_case(run, "plain", "\"sigma3\": " + stress + "000, \"resolution\": \"quick\"");
    }
  }
  Outcome report(const std::string& published)
  {
    const fs::path targets = series_.path() / "published.csv";
    std::ofstream(targets) << "set,quantity,unit,condition,value_test,value_model,source\n"
                           << published;
    return run_program({ENCASE_COMMAND, "report", "--brief", "--no-pictures", "--targets", targets,
                        series_.path()},
                       series_.path());
  }

  TemporaryFolder series_;
};

/// What the laboratory has not measured.
const std::string of_the_model = "plain_triaxial,peak deviator q,kPa,sigma3=50 kPa,,150,table\n";

}  // namespace

// E50 is half of the peak over 0.05 %: 146 and 292 MPa, 14.1 % below 170 and 15.1 % below 344. The
// tests give a failure line, so their peaks do not count beside it; nor does the porosity, which
// was given.
TEST_F(ResultSentences, TellWhatIsWithinFifteenPercentAndWhatIsNot)
{
  make_tests();
  const Outcome outcome = report(
      "plain_triaxial,secant modulus E50,MPa,sigma3=50 kPa,170,,table\n"
      "plain_triaxial,secant modulus E50,MPa,sigma3=100 kPa,344,,table\n"
      "plain_triaxial,peak deviator q,kPa,sigma3=50 kPa,999,,table\n"
      "plain_triaxial,porosity,-,prepared sample,0.35,,table\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output,
            "Met within 15 % of the laboratory: 1 of 2 values (E50 1 of 2).\n"
            "Not met: E50 at 100 kPa (plain) 292 for 344 MPa (-15 %).\n"
            "Checks of the runs: none of 14 missed, 2 not made.\n");
  EXPECT_EQ(read_text(series_.path() / "summary.txt"), outcome.output);
}

// Grains without cohesion at sin phi = 146 / 246. The laboratory's 5 kPa is within what 15 % of its
// smallest peak are worth there: 0.15 x 160 x (1 - sin 36) / (2 cos 36) = 6.1 kPa; 7 kPa is not.
TEST_F(ResultSentences, MeasureCohesionByThePeaks)
{
  EXPECT_NEAR(cohesion_allowance(160e3, 36.0 * M_PI / 180.0), 6.114e3, 1.0);
  make_tests();
  const auto said = [&](const std::string& cohesion) {
    return report(
               "plain_triaxial,apparent friction angle,deg,line,36,,table\n"
               "plain_triaxial,apparent cohesion,kPa,line," +
               cohesion +
               ",,table\n"
               "plain_triaxial,peak deviator q,kPa,sigma3=50 kPa,160,,table\n")
        .output;
  };
  EXPECT_NE(
      said("5").find("Met within 15 % of the laboratory: 2 of 2 values (phi 1 of 1, c 1 of 1).\n"
                     "Not met: none.\n"),
      std::string::npos)
      << said("5");
  EXPECT_NE(said("7").find("Not met: c (plain) 0 for 7 kPa (-100 %)."), std::string::npos)
      << said("7");
}

TEST_F(ResultSentences, OwnThatThereIsNothingToCompareWith)
{
  make_tests();
  EXPECT_EQ(report(of_the_model).lines().front(),
            "The laboratory has no values beside which these tests could stand.");
}

// Published values that a run of the study would stand beside.
TEST_F(ResultSentences, DoNotJudgeWhatReproducesNothingOfTheStudy)
{
  const std::string modulus = "plain_triaxial,secant modulus E50,MPa,sigma3=50 kPa,170,,table\n";
  make_tests();
  EXPECT_EQ(report(modulus).lines().front().rfind("Met within 15 % of the laboratory: 1 of 1 ", 0),
            0u);
  for (const char* stress : {"50", "100"})
    describe_case(series_.path() / (std::string("test_") + stress), "plain",
                  "\"sigma3\": " + std::string(stress) + "000, \"resolution\": \"quick\"", "");
  EXPECT_EQ(report(modulus).lines().front(),
            "The laboratory has no values beside which these tests could stand.");
}

// The page says of the same values what the terminal says.
TEST_F(ResultSentences, AgreeWithThePage)
{
  make_tests();
  const fs::path targets = series_.path() / "published.csv";
  report(
      "plain_triaxial,secant modulus E50,MPa,sigma3=50 kPa,100,,table\n"
      "plain_triaxial,secant modulus E50,MPa,sigma3=100 kPa,290,,table\n"
      "plain_triaxial,porosity,-,prepared sample,0.35,,table\n");
  const CaseRuns runs = read_case_runs({series_.path()});
  const Targets published(targets);
  const std::vector<SetResult> sets = evaluate(runs.runs, {}, published);
  const std::string on_page = agreement_sentence(agreement_numbers(sets, published));
  // 146 and 292 MPa: half of the level over 0.05 % strain.
  EXPECT_EQ(on_page,
            "Met within 15 % of the laboratory: 1 of 2 values; farthest off: E50 at 50 kPa "
            "(plain), 1.46 times it.");
  EXPECT_EQ(read_text(series_.path() / "summary.txt").substr(0, on_page.find(';')),
            on_page.substr(0, on_page.find(';')));
}

// Far below the confining stress that was asked for: both checks of it are missed in both tests.
TEST_F(ResultSentences, NameTheChecksThatWereMissed)
{
  make_tests();
  for (const char* run : {"test_50", "test_100"})
    describe_case(series_.path() / run, "plain", "\"sigma3\": 200000, \"resolution\": \"quick\"");
  const std::string last = report(of_the_model).lines().back();
  EXPECT_EQ(last.rfind("Checks of the runs: 4 of 14 missed (test_", 0), 0u) << last;
  EXPECT_NE(last.find("test_50 confining stress held"), std::string::npos) << last;
}
