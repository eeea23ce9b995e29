// SPDX-License-Identifier: GPL-2.0-only
// Grains in their places and beyond the walls, in the last file of a run: what the checks say, and
// what the program ends with.
#include "closed_form_case.h"
#include "files/pvd_collection.h"
#include "files/vtk_files.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

using Places = std::vector<std::array<double, 3>>;

// At 10 % strain the specimen is 180 mm high and 52.7 mm in radius.
constexpr double last_step = 10000;

/// The lower platen moves: at the last file it stands at 20 mm, the upper one at 200 mm.
const std::string lower_moves =
    R"("sigma3": 50000, "resolution": "quick", "height": 0.2, "density": 1738, "moving": 0)";
/// The upper one: 0 and 180 mm.
const std::string upper_moves =
    R"("sigma3": 50000, "resolution": "quick", "height": 0.2, "density": 1738, "moving": 1)";

void write_grains_at(const fs::path& run, const Places& places)
{
  std::vector<GrainRecord> grains;
  for (const auto& place : places) {
    GrainRecord grain{};
    grain.radius = 4e-3;
    grain.position = place;
    grains.push_back(grain);
  }
  fs::create_directories(run / "grains");
  std::ofstream(run / "grains/grains.pvd") << pvd_text({{last_step, "last.vtp"}});
  ASSERT_TRUE(write_grains(run / "grains/last.vtp", grains, {}));
}

/// A sleeve of 24 flat sides from 0 to 200 mm, 50 mm from the axis at its ends, 70 mm halfway up.
void write_sleeve_surface(const fs::path& run)
{
  constexpr int sides = 24;
  std::ostringstream points, corners, ends;
  for (const auto& [z, radius] : {std::pair{0.0, 0.05}, {0.1, 0.07}, {0.2, 0.05}})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / sides;
      points << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << ' ' << z << '\n';
    }
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < sides; ++i) {
      const int a = sides * ring + i, b = sides * ring + (i + 1) % sides;
      corners << a << ' ' << b << ' ' << b + sides << ' ' << a << ' ' << b + sides << ' '
              << a + sides << '\n';
    }
  for (int i = 1; i <= 4 * sides; ++i) ends << 3 * i << ' ';
  fs::create_directories(run / "sleeve");
  std::ofstream(run / "sleeve/sleeve.pvd") << pvd_text({{last_step, "last.vtp"}});
  std::ofstream(run / "sleeve/last.vtp")
      << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
      << "<Piece NumberOfPoints=\"" << 3 * sides << "\" NumberOfPolys=\"" << 4 * sides
      << "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n"
      << points.str() << "</DataArray></Points><Polys>"
      << "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
      << corners.str() << "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">"
      << ends.str() << "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
}

/// A series of one run.
class CheckVerdicts : public ::testing::Test {
 protected:
  fs::path make_run(const std::string& kind, const std::string& variables)
  {
    write_case(series_.path() / kind, kind);
    describe_case(series_.path() / kind, kind, variables);
    return series_.path() / kind;
  }
  Outcome make_tables(const std::vector<std::string>& options = {})
  {
    std::vector<std::string> words{ENCASE_COMMAND, "report", "--no-pictures", series_.path()};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words, series_.path());
  }
  /// The row of checks.csv about grains outside, or about something else.
  std::string row(const std::string& check = "outside")
  {
    std::istringstream text(read_text(series_.path() / "checks.csv"));
    for (std::string line; std::getline(text, line);)
      if (line.find(check) != std::string::npos) return line;
    return {};
  }
  /// What it has found there, the word but two.
  double found(const std::string& check)
  {
    const std::string line = row(check);
    const std::size_t verdict = line.rfind(','), allowed = line.rfind(',', verdict - 1);
    return std::stod(line.substr(line.rfind(',', allowed - 1) + 1));
  }
  static bool ends_with(const std::string& text, const std::string& end)
  {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  }

 private:
  TemporaryFolder series_;
};

const Places between_all_walls{{0.0, 0.0, 0.021}, {0.0, 0.0, 0.179}, {0.0, -0.052, 0.1}};

}  // namespace

// A deck whose consolidation ends by the grains that bear (`floating` 0) is held to those: 2e-5 of
// all of them beside 8e-6 is equilibrium, and the other way round is not.
TEST_F(CheckVerdicts, HoldARunToTheRatioThatEndedItsConsolidation)
{
  const fs::path run = make_run("plain", lower_moves);
  const auto ratios = [&](double average, double bearing, const std::string& counts_floating) {
    write_case(run, "plain");
    describe_case(run, "plain", lower_moves);
    std::istringstream before(read_text(run / "history.csv"));
    std::ofstream after(run / "history.csv");
    std::string line;
    std::getline(before, line);
    after << line << ",unbalanced_maximum [-],unbalanced_bearing [-]\n";
    while (std::getline(before, line)) {
      const std::size_t at = line.find(",1e-6,");
      ASSERT_NE(at, std::string::npos);
      after << line.replace(at, 6, "," + std::to_string(average) + ",") << ",0," << bearing << '\n';
    }
    after.close();
    std::ofstream(run / "variables.csv")
        << "name,style,value\ncounts_floating,equal,\"" << counts_floating << "\"\n";
    make_tables();
  };
  const std::string check = "unbalanced force ratio", start = " at the start of shear";
  ratios(2e-5, 8e-6, "0");
  EXPECT_NE(row(check).find("(bearing)" + start), std::string::npos) << row(check);
  EXPECT_TRUE(ends_with(row(check), "1e-05,pass")) << row(check);
  ratios(8e-6, 2e-5, "0");
  EXPECT_TRUE(ends_with(row(check), "1e-05,FAIL")) << row(check);
  ratios(2e-5, 8e-6, "1");
  EXPECT_NE(row(check).find("(average)" + start), std::string::npos) << row(check);
  EXPECT_TRUE(ends_with(row(check), "1e-05,FAIL")) << row(check);
}

TEST_F(CheckVerdicts, PassWhereAllGrainsAreBetweenPlatensAndCylinder)
{
  write_grains_at(make_run("plain", lower_moves), between_all_walls);
  const Outcome outcome = make_tables({"--strict"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(ends_with(row(), "outside platens and cylinder, last file of grains\",0,0,pass"))
      << row();
  EXPECT_EQ(outcome.lines().back(), "0 of 7 checks missed.");
}

// Beyond the lower platen, the upper one, and the cylinder.
TEST_F(CheckVerdicts, FindTheGrainsBeyondPlatensAndCylinder)
{
  write_grains_at(make_run("plain", lower_moves), {{0.0, 0.0, 0.1},
                                                   {0.0, 0.0, 0.019},
                                                   {0.0, 0.0, 0.201},
                                                   {0.04, 0.04, 0.1},
                                                   {0.03, 0.03, 0.1}});
  EXPECT_EQ(make_tables().exit_code, 0);
  EXPECT_TRUE(ends_with(row(), ",3,0,FAIL")) << row();
}

TEST_F(CheckVerdicts, MissedOnesChangeTheExitCodeOnlyWhereAskedFor)
{
  write_grains_at(make_run("plain", lower_moves), {{0.0, 0.0, 0.019}});
  const Outcome usual = make_tables(), strict = make_tables({"--strict"});
  EXPECT_EQ(usual.exit_code, 0);
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_EQ(usual.lines().back(), "1 of 7 checks missed.");
  EXPECT_EQ(strict.lines().back(), "1 of 7 checks missed.");
}

// The flat sides are 69.4 mm from the axis where the corners are 70.
TEST_F(CheckVerdicts, FindTheGrainsBeyondTheSleeveWhereItIs)
{
  const fs::path run = make_run("encased", upper_moves);
  write_sleeve_surface(run);
  write_grains_at(run, {{0.069, 0.0, 0.1}, {0.0, 0.0, 0.001}, {0.052, 0.0, 0.02}});
  make_tables();
  EXPECT_TRUE(ends_with(row(), "outside platens and sleeve, last file of grains\",0,0,pass"))
      << row();
  // Beyond it halfway up; beyond it near its end, where halfway up is room; beyond a platen too.
  write_grains_at(run, {{0.0, 0.071, 0.1}, {0.06, 0.0, 0.02}, {0.0, 0.09, 0.181}, {0.0, 0.0, 0.1}});
  make_tables();
  EXPECT_TRUE(ends_with(row(), ",3,0,FAIL")) << row();
}

// Both platens of these tests bear 196 kPa, 188.7 on average over the first 1 % of strain, which
// begins at 50 kPa. Grains weigh what the run's own gravity makes them weigh: with 9.8 m/s^2
// 1738 (1 - 0.34) g 0.199 m = 2237 Pa.
TEST_F(CheckVerdicts, TakeTheWeightOffThatTheRunHad)
{
  const std::string weight = "equal but for the weight";
  make_run("plain", lower_moves);
  make_tables();
  EXPECT_NEAR(found(weight), 2237.0 / (188.7e3 + 1118.0), 1e-4) << row(weight);
  make_run("plain", lower_moves + ", \"gravity\": 0");
  make_tables();
  EXPECT_EQ(found(weight), 0.0) << row(weight);
}

TEST_F(CheckVerdicts, LookAtThePlatensAloneWhereASleeveLeftNoFile)
{
  write_grains_at(make_run("encased", upper_moves), {{0.3, 0.0, 0.1}, {0.0, 0.0, -0.001}});
  make_tables();
  EXPECT_TRUE(ends_with(row(), "outside the platens, last file of grains\",1,0,FAIL")) << row();
}

TEST_F(CheckVerdicts, DoNotPassWhatTheRunLeftNoFileFor)
{
  make_run("plain", lower_moves);
  const Outcome outcome = make_tables({"--strict"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(row().find("the run left no file of grains),-,0,not made"), std::string::npos) << row();
  EXPECT_EQ(outcome.lines().back(), "0 of 7 checks missed, 1 not made.");
}
