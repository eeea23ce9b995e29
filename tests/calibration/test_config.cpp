// SPDX-License-Identifier: GPL-2.0-only
// Wrong configuration files: one sentence with file and line, before anything runs.
#include "config/calibration_config.h"
#include "config/units.h"
#include "core/input_error.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;

namespace {

const std::string whole = R"(name: gravel
runs:
  program: formula
  cases: [plain_050, plain_150]
  set: {mu_r: 0.1}
parameters:
  - {name: modulus, low: 20 MPa, high: 400 MPa, scale: log, unit: Pa}
  - {name: mu, low: 0.2, high: 0.9}
targets:
  - {quantity: secant_modulus, case: plain_050, value: 10.9 MPa, tolerance: 5 %}
  - {quantity: friction_angle, value: 36.4 deg, tolerance: 1 deg, weight: 2}
  - {curve: lab.csv, case: plain_150, tolerance: 10 kPa, strains: 4, weight: 0}
design: {points: 30, morris_ways: 2}
search: {surrogates: [network, regression]}
budget: 500
)";

const std::string lab = "axial_strain [%],deviatoric_stress [kPa]\n0,0\n10,300\n20,200\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

CalibrationConfig read(const std::string& text, const TemporaryFolder& folder,
                       const std::string& curve = lab)
{
  std::ofstream(folder.path() / "a.yaml") << text;
  std::ofstream(folder.path() / "lab.csv") << curve;
  return read_calibration(folder.path() / "a.yaml");
}

void expect_refused(const std::string& from, const std::string& to, const std::string& sentence,
                    const std::string& curve = lab)
{
  const TemporaryFolder folder;
  try {
    read(from.empty() ? to : replaced(whole, from, to), folder, curve);
    ADD_FAILURE() << "not refused: " << to;
  } catch (const InputError& problem) {
    std::string said = problem.what();
    const std::string path = folder.path().string() + "/";
    for (std::size_t at; (at = said.find(path)) != std::string::npos;) said.erase(at, path.size());
    EXPECT_EQ(said, sentence);
  }
}

}  // namespace

TEST(CalibrationConfig, IsReadInSiUnits)
{
  const TemporaryFolder folder;
  const CalibrationConfig found = read(whole, folder);
  EXPECT_EQ(found.name, "gravel");
  EXPECT_EQ(found.runs.kind, RunKind::formula);
  EXPECT_EQ(found.runs.set, (Settings{{"mu_r", "0.1"}}));
  EXPECT_DOUBLE_EQ(found.space[0].high, 400e6);
  EXPECT_NEAR(found.space.value(0, 0.5), std::sqrt(20e6 * 400e6), 1.0);
  EXPECT_NEAR(found.space.value(1, 0.5), 0.55, 1e-12);
  EXPECT_NEAR(found.space.share(0, found.space.value(0, 0.3)), 0.3, 1e-12);
  ASSERT_EQ(found.targets.size(), 3u);
  EXPECT_DOUBLE_EQ(found.targets[0].tolerance, 0.05 * 10.9e6);
  EXPECT_NEAR(found.targets[1].value, 0.635300, 1e-6);
  EXPECT_EQ(found.targets[1].cases, found.runs.cases);
  ASSERT_EQ(found.targets[2].strain.size(), 4u);
  const double strain[] = {0.05, 0.1, 0.15, 0.2}, stress[] = {150e3, 300e3, 250e3, 200e3};
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_NEAR(found.targets[2].strain[n], strain[n], 1e-12);
    EXPECT_NEAR(found.targets[2].stress[n], stress[n], 1e-6);
  }
  EXPECT_EQ(found.design.morris_ways, 2);
  EXPECT_EQ(found.search.surrogates.front(), SurrogateKind::network);
  EXPECT_EQ(found.budget, 500);
}

TEST(CalibrationConfig, RefusesWhatItDoesNotKnowWithItsLine)
{
  expect_refused("tolerance: 5 %", "tolerence: 5 %",
                 "unknown key 'tolerence' of a target in line 10 of 'a.yaml', expected one of: "
                 "quantity, curve, strains, case, cases, value, tolerance, weight");
  expect_refused(
      "budget", "bugdet",
      "unknown key 'bugdet' of a calibration in line 15 of 'a.yaml', expected one of: name, "
      "title, runs, parameters, targets, known, design, search, budget");
  expect_refused(
      "quantity: secant_modulus", "quantity: E50",
      "'quantity' in line 10 of 'a.yaml' must be one of secant_modulus, peak_q, "
      "peak_strain, end_q, end_ratio, end_volumetric_strain, radial_strain_25, "
      "radial_strain_50, radial_strain_75, porosity, friction_angle, cohesion, found 'E50', "
      "write for example 'quantity: secant_modulus'");
  expect_refused("network, regression", "forest",
                 "'surrogates' in line 14 of 'a.yaml' takes regression, network and kriging, found "
                 "'forest', write for example '[regression, network]'");
}

TEST(CalibrationConfig, RefusesKnownPointsThatItCannotRun)
{
  const auto known = [](const std::string& point) { return "known: [{" + point + "}]\nbudget"; };
  expect_refused("budget", known("modulus: 10 MPa, mu: 0.5"),
                 "'modulus' in line 15 of 'a.yaml' must be within the range of its parameter, "
                 "2e+07 to 4e+08, found '10 MPa', widen the range or leave the point out");
  expect_refused(
      "budget", known("modulus: 30 MPa"),
      "a known point in line 15 of 'a.yaml' must have the key 'mu', found none, write 'mu: ...'");
  expect_refused("budget", known("modulus: 30 MPa, mu: 0.5, kappa: 1"),
                 "unknown key 'kappa' of a known point in line 15 of 'a.yaml', expected one of: "
                 "modulus, mu");
}

TEST(CalibrationConfig, ReadsAKnownPointAsSharesOfTheRanges)
{
  const TemporaryFolder folder;
  const CalibrationConfig config = read(
      replaced(whole, "budget", "known: [{modulus: 89.4427191 MPa, mu: 0.55}]\nbudget"), folder);
  ASSERT_EQ(config.known.size(), 1u);
  EXPECT_NEAR(config.known[0][0], 0.5, 1e-9);  // the geometric mean of 20 and 400
  EXPECT_NEAR(config.known[0][1], 0.5, 1e-9);
}

TEST(CalibrationConfig, RefusesValuesThatCannotBe)
{
  expect_refused(
      "high: 400 MPa", "high: 4 MPa",
      "'high' in line 7 of 'a.yaml' must be larger than 'low', found '4 MPa' and '20 MPa', "
      "write the larger one there");
  expect_refused(
      "low: 20 MPa", "low: -1",
      "'low' in line 7 of 'a.yaml' must be above 0 with 'scale: log', found '-1', write a "
      "small number or 'scale: linear'");
  expect_refused(
      "value: 36.4 deg", "value: 36.4",
      "'value' in line 11 of 'a.yaml' takes a number in one of the units rad, deg, found "
      "'36.4', write for example '36.4 deg'");
  expect_refused(
      "10.9 MPa", "10.9 kN",
      "'value' in line 10 of 'a.yaml' takes a number in one of the units Pa, kPa, MPa, GPa, "
      "found '10.9 kN', write for example '1 Pa'");
  expect_refused(
      "points: 30", "points: 3",
      "'points' in line 13 of 'a.yaml' takes a whole number from 10 to 100000, found '3', "
      "write for example 'points: 60'");
  expect_refused(
      "weight: 2", "weight: -2",
      "'weight' in line 11 of 'a.yaml' must not be negative, found '-2', write 0 for a value "
      "that is foretold and not fitted");
  expect_refused("tolerance: 5 %", "tolerance: 0",
                 "'tolerance' in line 10 of 'a.yaml' must be above 0, found '0', write for example "
                 "'5 %' of the value");
  expect_refused(
      "name: mu,", "name: modulus,",
      "'name' in line 8 of 'a.yaml' must be another one for each parameter, found 'modulus' "
      "twice, leave one out");
}

TEST(CalibrationConfig, RefusesWhatIsMissingOrInTheWrongPlace)
{
  expect_refused("name: gravel", "title: gravel",
                 "a calibration in line 1 of 'a.yaml' must have the key 'name', found none, write "
                 "'name: ...'");
  expect_refused(
      "case: plain_050", "case: plain_100",
      "'case' in line 10 of 'a.yaml' must be one of 'cases' of 'runs', found 'plain_100', "
      "expected one of: plain_050 plain_150");
  expect_refused("value: 10.9 MPa, ", "",
                 "a target in line 10 of 'a.yaml' must have the key 'value', found none, write "
                 "'value: ...'");
  expect_refused("curve: lab.csv, ", "",
                 "a target in line 12 of 'a.yaml' takes 'quantity' with 'value', or 'curve', found "
                 "neither, write one of them");
  expect_refused(
      "{mu_r: 0.1}", "0.1",
      "'set' in line 5 of 'a.yaml' takes lines 'NAME: VALUE' below it, found something else, "
      "write for example 'set: {sigma3: 50e3}'");
  expect_refused(
      "", "name: [gravel\n",
      "'a.yaml' must be YAML, found 'end of sequence flow not found' in line 2, compare with "
      "calibration/plain_triaxial.yaml");
  expect_refused(
      "", "gravel\n",
      "a calibration in line 1 of 'a.yaml' takes lines 'key: value', found 'gravel', write "
      "for example 'name: ...'");
}

TEST(CalibrationConfig, RefusesCurvesThatAreNone)
{
  expect_refused(
      "budget", "budget",
      "the file of 'curve' in line 12 of 'a.yaml' must have a column 'axial_strain [-]', "
      "found 'strain, q', write it in its first line",
      "strain,q\n0,0\n1,1\n");
  expect_refused(
      "budget", "budget",
      "'curve' in line 12 of 'a.yaml': axial strain must not fall from row to row, found "
      "0.01 after 0.02 in row 2, remove the rows that a restart wrote twice",
      "axial_strain [-],deviatoric_stress [Pa]\n0.02,0\n0.01,1\n");
}

TEST(Units, AreReadAndWrittenBothWays)
{
  EXPECT_DOUBLE_EQ(read_in_unit("a", "5%", "-"), 0.05);
  EXPECT_DOUBLE_EQ(read_in_unit("a", "3 kN/m", "N/m"), 3000.0);
  EXPECT_DOUBLE_EQ(read_in_unit("a", "1e5", "Pa"), 1e5);
  EXPECT_EQ(in_usual_unit(10.9e6, "Pa"), "10.9 MPa");
  EXPECT_EQ(in_usual_unit(154.3e3, "Pa"), "154.3 kPa");
  EXPECT_EQ(in_usual_unit(0.5, "-"), "0.5");
  EXPECT_EQ(in_usual_unit(M_PI / 6.0, "rad"), "30 deg");
}
