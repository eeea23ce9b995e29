// SPDX-License-Identifier: GPL-2.0-only
// Columns of two gradations in one folder, beside the values of the study's own (Table 7,
// section 4.2).
#include "closed_form_case.h"
#include "drawing/figures.h"
#include "report/page_parts.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <regex>
#include <tuple>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path published = fs::path(ENCASE_SOURCE) / "postprocess/targets.csv";

/// A column whose lower platen bears 50 kPa and `strength` times 300 kPa.
void make_column(const fs::path& run, const std::string& gradation, double strength,
                 const std::string& parameters = "study", const std::string& reproduces = "Table 7")
{
  write_case(run, "encased", true, 1.0, strength, 0.5);
  describe_case(run, "encased",
                R"("sigma3": 50000, "radius": 0.05, "height": 0.5, "relative_density": 0.8,
"resolution": "quick", "parameters": ")" +
                    parameters + R"(", "gradation": "common/gradation_column_)" + gradation +
                    ".csv\"",
                reproduces);
}

/// Columns of 100 mm x 500 mm, evaluated, whose sleeves grow evenly to 3 mm at 30 mm and whose
/// three spheres have a porosity of 0.24 and a coordination number of 7.
class Columns {
 public:
  explicit Columns(const std::vector<std::string>& gradations,
                   const std::string& reproduces = "Table 7")
  {
    for (const std::string& gradation : gradations)
      make_column(series_.path() / gradation, gradation, 1.0, "study", reproduces);
    found_ = read_case_runs({series_.path()});
    sets_ = evaluate(found_.runs, {}, targets_);
    for (TestResult& test : sets_.front().tests) {
      for (const double strain : {0.0, 0.03, 0.06})
        test.profiles.push_back({strain, {0.0, 0.235, 0.47}, {0.0, 0.05 * strain, 0.0}});
      for (const double height : {0.04, 0.25, 0.46}) {
        test.spheres.emplace_back();
        for (const double strain : {0.0, 0.03, 0.06}) {
          SphereSample sample{};
          sample.axial_strain = strain;
          sample.height = height;
          sample.porosity_less_overlap = 0.24;
          sample.coordination_number = 7.0;
          test.spheres.back().push_back(sample);
        }
      }
    }
  }
  Figure figure(const std::string& name) const
  {
    for (const auto& figures :
         {column_series_figures(sets_, targets_), column_figures(sets_, targets_)})
      for (const Figure& figure : figures)
        if (figure.name == name) return figure;
    ADD_FAILURE() << "no figure " << name;
    return {};
  }

 private:
  TemporaryFolder series_;
  const Targets targets_{published};
  CaseRuns found_;
  std::vector<SetResult> sets_;
};

/// The curve or mark of `panel` that its legend calls so; an empty one without.
Series called(const Panel& panel, const std::string& label)
{
  for (const Series& series : panel.series)
    if (series.label == label) return series;
  std::string labels;
  for (const Series& series : panel.series) labels += "'" + series.label + "' ";
  ADD_FAILURE() << "no '" << label << "' among " << labels;
  return {"", {0.0}, {0.0}, black};
}

void expect_all(const std::vector<double>& found, double value)
{
  ASSERT_FALSE(found.empty());
  for (const double one : found) EXPECT_NEAR(one, value, 1e-9);
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
  const Targets targets(published);
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

// Section 3.1: 120 kPa soon (read at 1 mm), 276 kPa; at 30 mm the upper platen stands at 470
// mm, 1.5 and 2 diameters above 320 and 270 mm.
TEST(ColumnMarks, OfFigure11AreTheStudysPressuresAndDepths)
{
  const Columns columns({"S1"});
  for (const Panel& panel : columns.figure("column_pressure_density").panels) {
    const Series soon = called(panel, "study: 120 kPa soon");
    expect_all(soon.x, 1.0);
    expect_all(soon.y, 120.0);
    expect_all(called(panel, "study: capacity 276 kPa").y, 276.0);
  }
  const Panel profile = columns.figure("column_profile").panels.front();
  expect_all(called(profile, "study: largest 1.5 D deep").y, 320.0);
  expect_all(called(profile, "study: within 2 D deep").y, 270.0);
}

// Section 3.2: porosities from 0.22 to 0.26, coordination numbers between 4 and 5, before loading.
// No mark lies on the frame.
TEST(ColumnMarks, OfFigures14And15AreBothEndsOfTheStudysRanges)
{
  const Columns columns({"S1"});
  for (const auto& [name, low, high, low_label, high_label] :
       {std::tuple("column_porosity_S1", 0.22, 0.26, "0.22", "0.26"),
        std::tuple("column_coordination_S1", 4.0, 5.0, "4", "5")}) {
    const Figure figure = columns.figure(name);
    ASSERT_EQ(figure.panels.size(), 2u);
    for (const auto& [value, label] : {std::pair(low, low_label), std::pair(high, high_label)}) {
      expect_all(called(figure.panels[0], std::string("study, start: ") + label).y, value);
      expect_all(called(figure.panels[1], std::string("study, start: ") + label).x, value);
    }
    EXPECT_GT(figure.panels[0].y.margin, 0.0);
    EXPECT_GT(figure.panels[1].x.margin, 0.0);
  }
}

// At 24 mm the upper platen stands at 476 mm.
TEST(ColumnMarks, OfFigure17AreTheDepthsOfTheStudysColumn)
{
  const Panel panel = Columns({"S1"}).figure("column_expansion_density").panels.at(1);
  expect_all(called(panel, "study: largest 1.5 D deep").y, 326.0);
  expect_all(called(panel, "study: within 2 D deep").y, 276.0);
}

// Section 4.2: pronounced from 1 to 2 diameters below the top; 1.95, 2.16 and 2.34 mm at 24 mm.
TEST(ColumnMarks, OfFigure19AreTheDepthsAndTheExpansionsOfTheStudysGradations)
{
  const Columns columns({"S1", "S2", "S3", "S4"});
  const Panel panel = columns.figure("column_expansion_gradation").panels.at(1);
  expect_all(called(panel, "study: pronounced from 1 D deep").y, 376.0);
  expect_all(called(panel, "study: pronounced to 2 D deep").y, 276.0);
  for (const auto& [label, value] :
       {std::pair("study, S2: 1.95 mm", 1.95), std::pair("study, S3: 2.16 mm", 2.16),
        std::pair("study, S4: 2.34 mm", 2.34)}) {
    const Series mark = called(panel, label);
    expect_all(mark.x, value);
    ASSERT_EQ(mark.y.size(), 2u);
    EXPECT_NEAR(mark.y.front(), 276.0, 1e-9);
    EXPECT_NEAR(mark.y.back(), 376.0, 1e-9);
  }
  for (const Series& series : panel.series)
    EXPECT_EQ(series.label.find("1.5 D"), std::string::npos);
}

// A user's own columns, as like the study's as they may be.
TEST(ColumnMarks, AreLeftOutWhereNoColumnRepeatsTheStudy)
{
  const Columns columns({"S1", "S2"}, "");
  for (const char* name : {"column_pressure_density", "column_pressure_gradation",
                           "column_expansion_density", "column_expansion_gradation",
                           "column_profile", "column_porosity_S1", "column_coordination_S1"})
    for (const Panel& panel : columns.figure(name).panels)
      for (const Series& series : panel.series)
        EXPECT_EQ(series.label.rfind("study", 0), std::string::npos) << name << series.label;
}

// 200 and 350 kPa over 276 kPa (section 3.1).
TEST(ColumnSeries, OfTwoSetsHasAColumnAndARatioOfEach)
{
  const TemporaryFolder series;
  make_column(series.path() / "one", "S1", 0.5, "laboratory");
  make_column(series.path() / "other", "S1", 1.0, "study");
  run_program({ENCASE_COMMAND, "report", "--no-pictures", series.path()}, series.path());
  const std::string text = read_text(series.path() / "beside_study.txt");
  EXPECT_TRUE(has(text, "set laboratory +ratio laboratory +set study +ratio study *\n")) << text;
  EXPECT_TRUE(has(text, "bearing capacity +kPa +S1 .* 276 +200 +0\\.72 +350 +1\\.27 *\n")) << text;
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
