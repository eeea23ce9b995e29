// SPDX-License-Identifier: GPL-2.0-only
// Runs made with several sets of parameters in one folder: each set has its own line and its own
// tables, and what the study gives values for stands side by side.
#include "closed_form_case.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

class ParameterSets : public ::testing::Test {
 protected:
  /// Plain tests at 50 and 100 kPa that bear q = 2.92 `strength` sigma3.
  void make_tests(const std::string& parameters, double strength)
  {
    for (const int factor : {1, 2}) {
      const std::string stress = std::to_string(50 * factor);
      const fs::path run = series_.path() / (parameters + "_" + stress);
      write_case(run, "plain", true, factor, strength);
      describe_case(run, "plain",
                    "\"sigma3\": " + stress + "000, \"resolution\": \"quick\", \"parameters\": \"" +
                        parameters + "\"");
    }
  }
  std::string tables()
  {
    return run_program({ENCASE_COMMAND, "report", "--no-pictures", series_.path()}, series_.path())
        .output;
  }
  std::string file(const std::string& name) { return read_text(series_.path() / name); }
  static bool has(const std::string& text, const std::string& pattern)
  {
    return std::regex_search(text, std::regex(pattern));
  }

 private:
  TemporaryFolder series_;
};

// Grains without cohesion: sin phi = q / (q + 2 sigma3), 146 / 246 and 73 / 173.
const std::string angle_of_whole = "36\\.41", angle_of_half = "24\\.96";

}  // namespace

TEST_F(ParameterSets, HaveALineEach)
{
  make_tests("laboratory", 1.0);
  make_tests("study", 0.5);
  const std::string text = tables(), csv = file("table.csv");
  EXPECT_TRUE(has(
      csv, "plain_triaxial,laboratory,all,apparent friction angle phi,deg," + angle_of_whole + ","))
      << csv;
  EXPECT_TRUE(
      has(csv, "plain_triaxial,study,all,apparent friction angle phi,deg," + angle_of_half + ","))
      << csv;
  EXPECT_FALSE(has(text, "mixes")) << text;
}

TEST_F(ParameterSets, StandSideBySideBesideTheStudy)
{
  make_tests("laboratory", 1.0);
  make_tests("study", 0.5);
  const std::string text = tables();
  EXPECT_TRUE(has(text,
                  "quantity +sigma3 \\[kPa\\] +unit +set laboratory +to laboratory \\[%\\] +"
                  "set study +to laboratory \\[%\\] +laboratory +model"))
      << text;
  EXPECT_TRUE(has(text, "apparent friction angle phi +- +deg +" + angle_of_whole + " +[-+]0\\.0 +" +
                            angle_of_half + " +-31\\.4 +36\\.4 +36\\.5"))
      << text;
  EXPECT_TRUE(has(text, "peak deviator q +50 +kPa +146\\.0 +-5\\.4 +73\\.0 +-52\\.7 +154\\.3 "))
      << text;
  EXPECT_TRUE(has(text, "peak deviator q +100 +kPa +292\\.0 +-2\\.7 +146\\.0 ")) << text;
  EXPECT_TRUE(has(file("checks.txt"), "study_50 +study +confining stress held")) << text;
}

TEST_F(ParameterSets, AreNamedWhereThereIsOne)
{
  make_tests("mine", 1.0);
  const std::string text = tables();
  EXPECT_TRUE(has(text, "^Plain triaxial tests, parameters mine, resolution quick, q from"))
      << text;
  EXPECT_FALSE(has(text, "set mine")) << text;
  EXPECT_TRUE(has(file("checks.txt"), "mine_50 +mine +confining stress held")) << text;
}
