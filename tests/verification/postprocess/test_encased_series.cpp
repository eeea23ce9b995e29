// SPDX-License-Identifier: GPL-2.0-only
// A series made of closed forms: a plain test and an encased one of constant volume that mobilises
// 36.4 deg, with the study's sleeve (J 115 kN/m, R 50 mm, H 200 mm), both at 50 kPa.
#include "closed_form_case.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

void write_sleeve(const fs::path& folder)
{
  const double volume = 0.2 * 3.14159265358979 * 0.05 * 0.05;  // m^3
  std::ofstream sleeve(folder / "sleeve.csv");
  sleeve << "step [-],axial_strain [-],hoop_tension_mean [N/m],hoop_tension_max [N/m],"
            "hoop_strain_mean [-],hoop_strain_max [-],friction_force [N],enclosed_volume [m^3]\n";
  for (int i = 0; i <= 110; ++i) {
    const double strain = 0.002 * i;
    const double hoop = 1.0 / std::sqrt(1.0 - strain) - 1.0;
    const double area = volume / (0.2 * (1.0 - strain));
    sleeve << 100 * i << ',' << strain << ',' << 115e3 * hoop << ',' << 130e3 * hoop << ',' << hoop
           << ',' << 1.2 * hoop << ',' << -0.5 * (q_top + sigma3) * area << ',' << volume << '\n';
  }
}

/// The rows of a CSV file without quoted words, each by the names above it.
std::vector<std::map<std::string, std::string>> rows_of(const fs::path& file)
{
  std::istringstream stream(read_text(file));
  const auto split = [](const std::string& line) {
    std::vector<std::string> words;
    std::istringstream text(line);
    for (std::string word; std::getline(text, word, ',');) words.push_back(word);
    return words;
  };
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = split(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> words = split(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < words.size(); ++i) rows.back()[names[i]] = words[i];
  }
  return rows;
}

Outcome make_tables(const fs::path& series)
{
  return run_program({ENCASE_COMMAND, "report", "--no-pictures", series}, series);
}

}  // namespace

TEST(EncasedSeries, StandsBesideTheClosedForm)
{
  const TemporaryFolder series;
  write_case(series.path() / "plain", "plain");
  write_case(series.path() / "encased", "encased");
  write_sleeve(series.path() / "encased");
  const Outcome outcome = make_tables(series.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;

  const auto rows = rows_of(series.path() / "theory.csv");
  ASSERT_EQ(rows.size(), 4u);
  auto at_5 = rows[0], at_10 = rows[1];
  // Worked out beforehand for constant volume: 2.988 and 6.221 kN/m, 58.24 and 118.0 kPa.
  EXPECT_NEAR(std::stod(at_5["T [kN/m]"]), 2.988, 1.1e-3);
  EXPECT_NEAR(std::stod(at_10["T [kN/m]"]), 6.221, 1.1e-3);
  EXPECT_NEAR(std::stod(at_5["dsigma3 [kPa]"]), 58.24, 0.1);
  EXPECT_NEAR(std::stod(at_10["dsigma3 [kPa]"]), 118.0, 0.1);
  EXPECT_NEAR(std::stod(at_5["q theory [kPa]"]), kp_of_core * (50.0 + 58.24) - 50.0, 0.3);
  EXPECT_NEAR(std::stod(at_10["q theory [kPa]"]), kp_of_core * (50.0 + 118.0) - 50.0, 0.3);
  EXPECT_NEAR(std::stod(at_5["q top [kPa]"]), 900.0, 0.1);
  EXPECT_NEAR(std::stod(at_5["q bottom [kPa]"]), 300.0, 0.1);
  EXPECT_NEAR(std::stod(at_5["friction share [%]"]), 50.0, 0.1);
}

TEST(EncasedSeries, TellsRadialStrainAsExpansionAndTensionBeyondTheStripTest)
{
  const TemporaryFolder series;
  write_case(series.path() / "encased", "encased");
  write_sleeve(series.path() / "encased");
  const Outcome outcome = make_tables(series.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const std::string table = read_text(series.path() / "table.csv");
  EXPECT_NE(table.find("0.75H at the end of the test, from the bottom, expansion +\",%,16.50"),
            std::string::npos)
      << table;
  // 130 kN/m (1 / sqrt(0.78) - 1) = 17.2 kN/m are more than 9.2, and no failure.
  const std::string checks = read_text(series.path() / "checks.csv");
  EXPECT_NE(checks.find(",17.2,9.2,not required"), std::string::npos) << checks;
  EXPECT_TRUE(outcome.says("0 of 6 checks missed, 1 not made."));
}

// Without the stress of the core there is no friction angle, without a sleeve record nothing to
// compare.
TEST(EncasedSeries, LeavesOutWhatTheRunsDoNotSay)
{
  const TemporaryFolder series;
  write_case(series.path() / "encased", "encased", false);
  EXPECT_EQ(make_tables(series.path()).exit_code, 0);
  EXPECT_FALSE(fs::exists(series.path() / "theory.csv"));
  write_sleeve(series.path() / "encased");
  EXPECT_EQ(make_tables(series.path()).exit_code, 0);
  auto rows = rows_of(series.path() / "theory.csv");
  EXPECT_EQ(rows.at(0)["q theory [kPa]"], "");
  EXPECT_EQ(rows.at(0)["q top [kPa]"], "900.0");
}

// A test cut off early may start above half of what it reached.
TEST(EncasedSeries, LeavesOutTheModulusOfATestThatStartsAboveHalfItsPeak)
{
  const TemporaryFolder series;
  write_case(series.path() / "encased", "encased");
  const fs::path history = series.path() / "encased" / "history.csv";
  std::string text = read_text(history);
  text.erase(text.find('\n') + 1, text.find("\n0.001,") - text.find('\n'));  // the row at rest
  std::ofstream(history) << text;
  const Outcome outcome = make_tables(series.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(outcome.says("No E50 of encased"));
  EXPECT_EQ(read_text(series.path() / "table.csv").find("E50"), std::string::npos);
}
