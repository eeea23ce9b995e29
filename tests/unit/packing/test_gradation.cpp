// SPDX-License-Identifier: GPL-2.0-only
#include "packing/gradation.h"

#include "core/input_error.h"
#include "packing/draw_diameters.h"
#include "packing/gradation_file.h"
#include "packing/grain_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace encased_column;

namespace {

const Gradation cinder_gravel{
    {0.001, 0.002, 7.1}, {0.002, 0.005, 11.2}, {0.005, 0.010, 68.8}, {0.010, 0.015, 12.9}};
const auto log_uniform = ClassDistribution::log_uniform;
const auto uniform = ClassDistribution::uniform;
const auto uniform_number = ClassDistribution::uniform_number;
const std::vector<ClassDistribution> all_distributions{log_uniform, uniform, uniform_number};
const double specimen_volume = pi * 0.05 * 0.05 * 0.2;

/// The sentence `action` stops with.
template <typename Action>
std::string refusal(const Action& action)
{
  try {
    action();
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "no refusal";
}

void expect_refusal(const Gradation& gradation, const std::string& sentence)
{
  const std::string found = refusal([&] { check_gradation(gradation); });
  EXPECT_NE(found.find(sentence), std::string::npos) << found;
}

Gradation read(const std::string& text)
{
  std::istringstream in(text);
  return read_gradation(in, "soil.csv");
}

const std::string header = "diameter_low [m],diameter_high [m],mass_percent [%]\n";

}  // namespace

TEST(PassingDiameter, OfALogUniformClassIsAGeometricMean)
{
  const Gradation one{{0.002, 0.008, 100.0}};
  EXPECT_DOUBLE_EQ(passing_diameter(one, log_uniform, 50.0), 0.004);
  EXPECT_DOUBLE_EQ(passing_diameter(one, log_uniform, 60.0), 0.002 * std::pow(4.0, 0.6));
}

TEST(PassingDiameter, OfAUniformClassIsAnArithmeticMean)
{
  EXPECT_DOUBLE_EQ(passing_diameter({{0.002, 0.008, 100.0}}, uniform, 60.0), 0.0056);
}

TEST(PassingDiameter, OfAClassUniformByNumberGoesWithTheFourthRoot)
{
  EXPECT_NEAR(passing_diameter({{1.0, 3.0, 100.0}}, uniform_number, 50.0), std::pow(41.0, 0.25),
              1e-14);
}

TEST(PassingDiameter, SkipsAnEmptyClass)
{
  const Gradation gap{{0.001, 0.002, 50.0}, {0.002, 0.005, 0.0}, {0.005, 0.010, 50.0}};
  EXPECT_DOUBLE_EQ(passing_diameter(gap, uniform, 50.0), 0.002);
  EXPECT_DOUBLE_EQ(passing_diameter(gap, uniform, 75.0), 0.0075);
  const Gradation coarse{{0.001, 0.002, 0.0}, {0.002, 0.005, 100.0}};
  EXPECT_DOUBLE_EQ(passing_diameter(coarse, uniform, 0.0), 0.002);
}

TEST(CharacteristicSizes, OfCinderGravelGiveThePublishedCoefficients)
{
  const CharacteristicSizes sizes = characteristic_sizes(cinder_gravel, log_uniform);
  EXPECT_NEAR(sizes.uniformity(), 3.00, 0.005);
  EXPECT_NEAR(sizes.curvature(), 1.64, 0.005);
}

// The study's Table 7, to its last digit. d60 of S3 follows from the percent between 10 and 20 mm
// alone when the curve is read log-uniform: so that is how the study reads its curves.
TEST(CharacteristicSizes, OfTheStudysOtherGradationsAgreeWithItsTable)
{
  const auto expect_sizes = [](const Gradation& gradation, double d10, double d30, double d60) {
    const CharacteristicSizes sizes = characteristic_sizes(gradation, log_uniform);
    EXPECT_NEAR(sizes.d10, d10, 0.05e-3);
    EXPECT_NEAR(sizes.d30, d30, 0.05e-3);
    EXPECT_NEAR(sizes.d60, d60, 0.06e-3);
  };
  const auto classes = [](double m1, double m2, double m3, double m4) {
    return Gradation{
        {0.001, 0.002, m1}, {0.002, 0.005, m2}, {0.005, 0.010, m3}, {0.010, 0.020, m4}};
  };
  expect_sizes(classes(8.4, 6.6, 45.0, 40.0), 2.5e-3, 6.3e-3, 10.0e-3);
  expect_sizes(classes(9.2, 7.8, 23.0, 60.0), 2.2e-3, 7.4e-3, 12.6e-3);
  expect_sizes(classes(9.5, 9.5, 1.0, 80.0), 2.1e-3, 10.9e-3, 14.2e-3);
}

TEST(CharacteristicSizes, OfGivenGrainsCountTheirMass)
{
  // Volumes 8, 1, 1 of 10: a tenth of the mass is reached with the first small grain.
  const CharacteristicSizes sizes = characteristic_sizes(std::vector<double>{2.0, 1.0, 1.0});
  EXPECT_DOUBLE_EQ(sizes.d10, 1.0);
  EXPECT_DOUBLE_EQ(sizes.d30, 2.0);
}

TEST(DrawDiameters, MeetsTheMassOfEveryClassAndTheWholeVolumeToRoundOff)
{
  for (const ClassDistribution distribution : all_distributions)
    for (const std::uint64_t seed : {0, 1, 77}) {
      const double solid = solid_volume(0.2, specimen_volume);
      const std::vector<double> diameters =
          draw_diameters(cinder_gravel, distribution, solid, seed);
      EXPECT_NEAR(volume_of(diameters) / solid, 1.0, 1e-12);
      EXPECT_NEAR(porosity_of(diameters, specimen_volume), 0.2, 1e-12);
      const std::vector<ClassContent> contents = sieve(cinder_gravel, diameters);
      for (std::size_t k = 0; k < contents.size(); ++k)
        EXPECT_NEAR(contents[k].mass_percent, cinder_gravel[k].mass_percent, 1e-9);
    }
}

// The sizes drawn follow the distribution inside a class too: the mass passing of the grains is
// that of the closed form, which the draw (by number) does not use.
TEST(DrawDiameters, FollowsTheDistributionInsideAClass)
{
  const Gradation one{{0.002, 0.006, 100.0}};
  for (const ClassDistribution distribution : all_distributions) {
    const std::vector<double> diameters = draw_diameters(one, distribution, 2e-3, 5);
    ASSERT_GT(diameters.size(), 10000u);
    for (const double percent : {10.0, 30.0, 60.0, 90.0})
      EXPECT_NEAR(passing_diameter(diameters, percent),
                  passing_diameter(one, distribution, percent), 2e-6);
  }
}

TEST(DrawDiameters, KeepsEveryGrainInItsClassAlsoWhenAClassHoldsFewGrains)
{
  const Gradation one{{0.010, 0.015, 100.0}};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const double solid = 5.3 * grain_volume(0.0125);
    const std::vector<double> diameters = draw_diameters(one, uniform_number, solid, seed);
    EXPECT_NEAR(volume_of(diameters) / solid, 1.0, 1e-12);
    EXPECT_LE(diameters.front(), 0.015);
    EXPECT_GE(diameters.back(), 0.010);
  }
}

TEST(DrawDiameters, OfCinderGravelComesNearThePublishedNumberOfGrains)
{
  const double solid = solid_volume(0.2, specimen_volume);
  const auto count = draw_diameters(cinder_gravel, uniform_number, solid, 1).size();
  EXPECT_NEAR(static_cast<double>(count), 54410.0, 0.002 * 54410.0);
}

TEST(DrawDiameters, IsTheSameForTheSameSeedOnlyAndSortedFromCoarseToFine)
{
  const auto draw = [](std::uint64_t seed) {
    return draw_diameters(cinder_gravel, log_uniform, 1e-4, seed);
  };
  EXPECT_EQ(draw(3), draw(3));
  EXPECT_NE(draw(3), draw(4));
  const std::vector<double> diameters = draw(3);
  EXPECT_TRUE(std::is_sorted(diameters.rbegin(), diameters.rend()));
}

TEST(DrawDiameters, RefusesAVolumeThatNoWholeNumberOfGrainsFills)
{
  for (const double grains : {0.5, 1.5}) {
    const std::string found = refusal([&] {
      draw_diameters({{0.010, 0.011, 100.0}}, uniform, grains * grain_volume(0.010), 1);
    });
    EXPECT_NE(found.find("the class 0.01 to 0.011 m holds"), std::string::npos) << found;
  }
}

TEST(DrawDiameters, RefusesMoreGrainsThanMemoryHolds)
{
  const std::string found = refusal([] { draw_diameters({{1e-6, 2e-6, 100.0}}, uniform, 1.0, 1); });
  EXPECT_NE(found.find("'finest'"), std::string::npos) << found;
}

// A number-uniform class of sizes 1 to 2 has the mean cube 15/4, from integrating x^3.
TEST(ExpectedCount, IsTheVolumeOverTheMeanGrainVolume)
{
  const double mean = pi / 6.0 * 15.0 / 4.0;
  EXPECT_NEAR(expected_count({{1.0, 2.0, 100.0}}, uniform_number, 10.0 * mean), 10.0, 1e-12);
}

TEST(ExpectedCount, AgreesWithTheGrainsDrawn)
{
  for (const ClassDistribution distribution : all_distributions)
    EXPECT_NEAR(static_cast<double>(draw_diameters(cinder_gravel, distribution, 1e-3, 1).size()),
                expected_count(cinder_gravel, distribution, 1e-3), 2.0);
}

TEST(WithoutFiner, LeavesOutTheFineClassesAndMakesTheRestAHundred)
{
  const Gradation rest = without_finer(cinder_gravel, log_uniform, 0.005);
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_DOUBLE_EQ(rest[0].mass_percent, 100.0 * 68.8 / 81.7);
  EXPECT_DOUBLE_EQ(rest[1].mass_percent, 100.0 * 12.9 / 81.7);
}

TEST(WithoutFiner, KeepsTheCoarserPartOfAClassItCuts)
{
  const Gradation two{{0.001, 0.004, 40.0}, {0.004, 0.008, 60.0}};
  const Gradation rest = without_finer(two, log_uniform, 0.002);
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_DOUBLE_EQ(rest[0].diameter_low, 0.002);
  EXPECT_NEAR(rest[0].mass_percent, 100.0 * 20.0 / 80.0, 1e-12);
}

TEST(WithoutFiner, RefusesToLeaveNothing)
{
  const std::string found = refusal([] { without_finer(cinder_gravel, uniform, 0.02); });
  EXPECT_NE(found.find("found 0.02 m"), std::string::npos) << found;
}

TEST(CheckGradation, AcceptsPercentsThatMissAHundredByRounding)
{
  EXPECT_NO_THROW(check_gradation({{0.001, 0.002, 33.33}, {0.002, 0.003, 66.66}}));
}

TEST(CheckGradation, RefusesWhatIsNoGradationAndNamesTheValue)
{
  expect_refusal({}, "at least one class, found none, write");
  expect_refusal({{0.001, 0.002, 50.0}, {0.002, 0.003, 49.98}}, "sum to 100, found 99.98");
  expect_refusal({{0.002, 0.001, 100.0}}, "0.002 to 0.001 m is reversed");
  expect_refusal({{0.001, 0.003, 50.0}, {0.002, 0.004, 50.0}}, "before, 0.003 m");
  expect_refusal({{0.0, 0.002, 100.0}}, "larger than zero, found 0 m");
  expect_refusal({{0.001, 0.002, -5.0}, {0.002, 0.003, 105.0}}, "has -5 %");
  expect_refusal({{0.001, 0.002, std::nan("")}}, "write a percent of zero or more");
}

TEST(SolidVolume, IsWhatThePorosityLeaves)
{
  EXPECT_DOUBLE_EQ(solid_volume(0.25, 8.0), 6.0);
}

TEST(SolidVolume, RefusesAPorosityOutOfReach)
{
  for (const double porosity : {-0.1, 0.05, 0.71, 1.0})
    EXPECT_NE(refusal([&] { solid_volume(porosity, 1.0); }).find("found " + in_words(porosity)),
              std::string::npos);
}

TEST(ReadGradation, SkipsCommentsAndEmptyLines)
{
  const Gradation read_back =
      read("# soil\n\n" + header + "0.001, 0.002 ,40\r\n#x\n0.002,0.005,60");
  ASSERT_EQ(read_back.size(), 2u);
  EXPECT_EQ(read_back[0].diameter_high, 0.002);
  EXPECT_EQ(read_back[1].mass_percent, 60.0);
}

TEST(ReadGradation, NamesTheFileAndTheLineOfAMistake)
{
  const auto of = [](const std::string& text) { return refusal([&] { read(text); }); };
  EXPECT_NE(of("0.001,0.002,100").find("found '0.001,0.002,100', write it above the classes"),
            std::string::npos);
  EXPECT_NE(of(header + "0.001,0.002").find("soil.csv:2 must have 3 values, found 2"),
            std::string::npos);
  EXPECT_NE(of(header + "0.001,2mm,100").find("found '2mm'"), std::string::npos);
  EXPECT_NE(of(header + "0.001,0.002,90").find("soil.csv: the mass percents"), std::string::npos);
}

TEST(WriteGradation, PutsWantedAndAchievedSideBySide)
{
  std::ostringstream out;
  write_gradation(out, {{0.001, 0.002, 100.0}}, {{99.5, 12}}, {12, 0.2, {1, 2, 4}, {1, 3, 6}});
  EXPECT_NE(out.str().find("0.001,0.002,100,99.5,12\n"), std::string::npos);
  EXPECT_NE(out.str().find("# Cu by sieve [-],4\n# Cc by sieve [-],1\n"), std::string::npos);
}

// Mass percents sum to 100 within 0.01: a file that is cut off loses more or nothing.
TEST(ReadGradation, OfAFileCutOffAnywhereIsRefusedOrTheSame)
{
  std::string text = "# a gravel\n" + header;
  for (const SizeClass& c : cinder_gravel)
    text += std::to_string(c.diameter_low) + "," + std::to_string(c.diameter_high) + "," +
            std::to_string(c.mass_percent) + "\n";
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string found = refusal([&] {
      const Gradation gradation = read(text.substr(0, size));
      ASSERT_EQ(gradation.size(), cinder_gravel.size()) << size;
      EXPECT_NEAR(gradation.back().mass_percent, cinder_gravel.back().mass_percent, 0.01) << size;
    });
    if (size < header.size()) {
      EXPECT_NE(found, "no refusal") << size;
    }
  }
}
