// SPDX-License-Identifier: GPL-2.0-only
// Runs of real decks by `encase run`, and what is read from them.
#include "runs/run_program.h"
#include "stages/run_plan.h"
#include "support/csv_table.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;
namespace fs = std::filesystem;

// A test of a hundred grains to 2 % of strain, and one that the deck refuses.
TEST(EncaseProgram, ReadsWhatTheReportOfTheSameRunsSays)
{
  const encased_column::testing::TemporaryFolder folder;
  encased_column::testing::prepare_small_cases(folder.path());
  CalibrationConfig config;
  config.file = folder.path() / "a.yaml";
  config.runs.cases = {"plain"};
  config.runs.cases_file = folder.path() / "small.csv";
  config.runs.ranks = "1";
  config.space = ParameterSpace({{"mu", "-", -1.0, 0.8, false}});
  const Places places = find_places();
  const std::vector<Case> rows = rows_of_cases(config, places);
  const std::vector<StoredPoint> points{{0, "design", 0, 1, Eigen::VectorXd::Ones(1)},
                                        {1, "design", 0, 1, Eigen::VectorXd::Zero(1)}};
  std::map<int, RunResult> results;
  const auto program = encase_program(config, places, folder.path() / "out", false);
  const RunsEnd end = program->make(
      runs_of(config, rows, points),
      [&](const PlannedRun& run, const RunResult& one) { results[run.key.point] = one; });
  EXPECT_EQ(end, RunsEnd::made);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_NE(results[1].problem.find("mu"), std::string::npos) << results[1].problem;
  ASSERT_TRUE(results[0].good()) << results[0].problem;

  const fs::path run = folder.path() / "out/runs/p0000_r0_plain";
  EXPECT_FALSE(fs::exists(run / "grains")) << "large files stay";
  const auto report = encased_column::testing::run_program(
      {ENCASE_COMMAND, "report", run.string(), "--no-pictures", "--output", "report"},
      folder.path());
  EXPECT_EQ(report.exit_code, 0) << report.output;
  const std::string table = encased_column::testing::read_text(folder.path() / "report/table.csv");
  const auto in_table = [&](const std::string& quantity) {
    const std::size_t line = table.find(quantity),
                      comma = table.find(',', table.find(',', line) + 1);
    return line == std::string::npos ? NAN : std::atof(table.c_str() + comma + 1);
  };
  EXPECT_NEAR(results[0].values.at("peak_q") / 1e3, in_table("peak deviator q"), 0.06) << table;
  EXPECT_NEAR(results[0].values.at("secant_modulus") / 1e6, in_table("secant modulus E50"), 0.006)
      << table;
}
