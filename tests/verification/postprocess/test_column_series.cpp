// SPDX-License-Identifier: GPL-2.0-only
// Columns of two gradations in one folder, beside the values of the study's own (Table 7,
// section 4.2).
#include "closed_form_case.h"
#include "drawing/figures.h"
#include "report/page_parts.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <regex>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// A column of S2 or S3 whose lower platen bears 50 kPa and `strength` times 300 kPa.
void make_column(const fs::path& run, const std::string& gradation, double strength)
{
  write_case(run, "encased", true, 1.0, strength);
  describe_case(run, "encased",
                R"("sigma3": 50000, "radius": 0.05, "height": 0.5, "relative_density": 0.8,
"resolution": "quick", "parameters": "study", "gradation": "common/gradation_column_)" +
                    gradation + ".csv\"");
}

bool has(const std::string& text, const std::string& pattern)
{
  return std::regex_search(text, std::regex(pattern));
}

std::string beside(const Rows& rows, const std::string& study)
{
  for (const auto& row : rows)
    if (row.front() == study) return row.back();
  return "no row";
}

}  // namespace

// 350 and 200 kPa over 228.5 and 239.4 kPa; Table 6 has 0.400 at 80 %.
TEST(ColumnSeries, StandsBesideTheStudyByGradation)
{
  const TemporaryFolder series;
  make_column(series.path() / "s2", "S2", 1.0);
  make_column(series.path() / "s3", "S3", 0.5);
  run_program({ENCASE_COMMAND, "report", "--no-pictures", series.path()}, series.path());
  const std::string text = read_text(series.path() / "beside_study.txt");
  EXPECT_TRUE(has(text, "vertical pressure at 24 mm +kPa +S2 .* 228\\.5 +350 +1\\.53")) << text;
  EXPECT_TRUE(has(text, "vertical pressure at 24 mm +kPa +S3 .* 239\\.4 +200 +0\\.84")) << text;
  EXPECT_TRUE(has(text, "vertical pressure at 24 mm +kPa +S4 .* 248\\.7 +not run +-")) << text;
  EXPECT_TRUE(has(text, "maximum radial expansion +mm +S2 at 24 mm .* 1\\.95 +not told +-"))
      << text;
  EXPECT_TRUE(has(text, "secant modulus E50 +MPa +sigma3=50 kPa .* not run")) << text;
  const std::string table = read_text(series.path() / "table.csv");
  EXPECT_TRUE(has(table, "s2,\"?porosity, of the sample in the laboratory\"?,-,0\\.4000")) << table;
}

// Table 6 has 0.417 at 40 %. The row asks for that sample; a set's own porosity, here 0.398, stands
// for that of the tests, 0.400 (Table 1), and 0.002 more than the set has is 0.002 more of it.
TEST(ColumnSeries, StandsForTheSampleThatItsRowNames)
{
  const TemporaryFolder series;
  const std::pair<std::string, std::string> rows[] = {
      {"loose", R"("porosity": 0.398, "sample_porosity": 0.417)"},
      {"tested", R"("porosity": 0.398)"},
      {"asked", R"("porosity": 0.396, "sample_porosity": 0.417)"}};
  for (const auto& [id, variables] : rows) {
    const fs::path run = series.path() / id;
    write_case(run, "encased");
    describe_case(run, "encased", "\"sigma3\": 50000, " + variables);
    fs::create_directories(run / "input");
    std::ofstream(run / "input/triaxial_encased.lmp")
        << "variable porosity index 0.398  # [-] at generation\n";
  }
  run_program({ENCASE_COMMAND, "report", "--no-pictures", series.path()}, series.path());
  const std::string table = read_text(series.path() / "table.csv");
  const std::string sample = ",\"?porosity, of the sample in the laboratory\"?,-,";
  EXPECT_TRUE(has(table, "loose" + sample + "0\\.4170")) << table;
  EXPECT_TRUE(has(table, "loose,\"?relative density of the sample in the laboratory\"?,%,40\\.0"))
      << table;
  EXPECT_TRUE(has(table, "tested" + sample + "0\\.4000")) << table;
  EXPECT_TRUE(has(table, "asked" + sample + "0\\.4150")) << table;
}

// 228.5, 239.4 and 248.7 kPa at 24 mm: on the upper platen, which bears 950 kPa here, a disc would
// hide the next one. Their bars follow one another about 24 mm, each at its own pressure.
TEST(ColumnSeries, KeepsTheStudysNumbersApart)
{
  const TemporaryFolder series;
  for (const std::string gradation : {"S2", "S3", "S4"})
    make_column(series.path() / gradation, gradation, 1.0);
  const CaseRuns found = read_case_runs({series.path()});
  const Targets targets(fs::path(ENCASE_SOURCE) / "postprocess/targets.csv");
  const std::vector<SetResult> sets = evaluate(found.runs, {}, targets);
  const std::vector<Figure> figures = column_series_figures(sets, targets);
  ASSERT_EQ(figures.front().name, "column_pressure_gradation");
  const Panel& upper = figures.front().panels.front();
  std::vector<Series> bars;
  for (const Series& series : upper.series)
    if (series.label.rfind("study, ", 0) == 0) bars.push_back(series);
  ASSERT_EQ(bars.size(), 3u);
  const std::vector<double> pressures{228.5, 239.4, 248.7};
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_EQ(bars[i].y, std::vector<double>(2, pressures[i]));
    EXPECT_EQ(bars[i].color, upper.series[i].color) << "of its column";
    EXPECT_GT(bars[i].x.back(), bars[i].x.front());
    if (i > 0) {
      EXPECT_GE(bars[i].x.front(), bars[i - 1].x.back() - 1e-9);
    }
  }
  EXPECT_NEAR(0.5 * (bars.front().x.front() + bars.back().x.back()), 24.0, 1e-9);
}

TEST(Counterparts, OfAColumnAreItsOwnFigures)
{
  CaseRun run;
  run.has_sleeve = true;
  TestResult test;
  test.run = &run;
  const std::vector<Figure> figures{{"column_pressure_gradation", "Pressure", "", {}},
                                    {"column_expansion_gradation", "Expansion", "", {}},
                                    {"column_profile", "Profile", "", {}}};
  const Rows rows = counterpart_rows(test, figures, {});
  EXPECT_EQ(beside(rows, "11a"), "Pressure");
  EXPECT_EQ(beside(rows, "11b"), "Profile");
  EXPECT_EQ(beside(rows, "17, 19"), "Expansion");
  EXPECT_EQ(beside(rows, "3"), "no: this test is encased");
}

TEST(Counterparts, OfATriaxialTestAreThoseOfItsSpecimen)
{
  CaseRun run;
  run.has_sleeve = true;
  TestResult test;
  test.run = &run;
  const Rows rows = counterpart_rows(test, {{"radial_profile", "Profile", "", {}}}, {});
  EXPECT_EQ(beside(rows, "11b"), "Profile");
  EXPECT_EQ(beside(rows, "17, 19"), "no: the run wrote no profile of a sleeve");
}
