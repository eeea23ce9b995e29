// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_settings.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace encased_column;

namespace {

GrowthSettings settings_of(const std::string& line)
{
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return GrowthSettings::read(GrowthSettings::keywords.read(words));
}

void expect_refused_settings(const std::string& line, const std::string& sentence)
{
  try {
    settings_of("from 0.5 " + line);
    ADD_FAILURE() << line << " is not refused";
  } catch (const InputError& problem) {
    EXPECT_NE(std::string(problem.what()).find(sentence), std::string::npos) << problem.what();
  }
}

const std::string under_stress = "stress 5e3 platens top bottom side side ";

}  // namespace

TEST(GrowthSettings, HaveAGoalWithAStressOnly)
{
  EXPECT_FALSE(settings_of("from 0.5").goal);
  const GrowthSettings settings = settings_of(
      "from 0.4 stages 30 relax 20 lower_friction 0.9 rest 1e-3 until limits " + under_stress);
  EXPECT_EQ(settings.start, 0.4);
  EXPECT_EQ(settings.stages, 30);
  EXPECT_EQ(settings.steps_per_stage, 20);
  ASSERT_TRUE(settings.goal);
  EXPECT_EQ(settings.goal->stress, 5e3);
  EXPECT_EQ(settings.goal->friction_ratio, 0.9);
  EXPECT_EQ(settings.goal->rest, 1e-3);
  EXPECT_EQ(settings.goal->until, GrowthGoal::Until::limits);
}

TEST(GrowthSettings, RefuseAStressThatIsNoneOrWithoutItsSpecimen)
{
  expect_refused_settings("stress -5e3 platens top bottom side side",
                          "'stress' must be larger than zero, found -5000");
  expect_refused_settings("stress 5e3 side side",
                          "'stress' needs the specimen that bears it, found no 'platens', write "
                          "'platens top bottom side side'");
  expect_refused_settings("stress 5e3 platens top bottom", "found no 'side'");
}

TEST(GrowthSettings, RefuseWhatCountsWithAStressOnly)
{
  for (const std::string words :
       {"platens top bottom", "side side", "lower_friction 0.9", "rest 1e-3", "until limits"})
    expect_refused_settings(words, "'" + words.substr(0, words.find(' ')) +
                                       "' counts with a stress only, found no 'stress', write for "
                                       "example 'stress 5e3' beside it");
}

TEST(GrowthSettings, RefuseValuesOutOfRange)
{
  expect_refused_settings(under_stress + "lower_friction 1",
                          "'lower_friction' must be between 0.5 and 0.99, found 1");
  expect_refused_settings(under_stress + "rest 0", "'rest' must be larger than zero, found 0");
  expect_refused_settings(under_stress + "until rest",
                          "'until' must be one of: full_size, limits; found 'rest'");
}
