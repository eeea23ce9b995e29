// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/sleeve_record.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(SleeveProfiles, AreTheRowsOfOneStepEach)
{
  const std::vector<SleeveProfile> profiles = profiles_of({{100, 100, 100, 200, 200},
                                                           {0.0, 0.0, 0.0, 0.05, 0.05},
                                                           {0.0, 0.1, 0.2, 0.0, 0.1},
                                                           {0.0, 0.0, 0.0, 0.0, 1e-3}});
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].axial_strain, 0.0);
  EXPECT_EQ(profiles[0].height, (std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_EQ(profiles[1].axial_strain, 0.05);
  EXPECT_EQ(profiles[1].radial_displacement, (std::vector<double>{0.0, 1e-3}));
}

// A run that went on from a restart file writes again what came after it.
TEST(SleeveProfiles, OfAStepThatComesTwiceAreThoseOfTheLaterRows)
{
  const std::vector<SleeveProfile> profiles = profiles_of({{100, 200, 200, 100, 100},
                                                           {0.01, 0.02, 0.02, 0.01, 0.01},
                                                           {0.0, 0.0, 0.1, 0.0, 0.1},
                                                           {1.0, 2.0, 3.0, 4.0, 5.0}});
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].radial_displacement, (std::vector<double>{4.0, 5.0}));
  EXPECT_EQ(profiles[1].radial_displacement, (std::vector<double>{2.0, 3.0}));
}

TEST(NearestPlaces, AreTheClosestStrainsWithinTheTolerance)
{
  const std::vector<double> strains{0.0, 0.04, 0.052, 0.09, 0.13};
  EXPECT_EQ(nearest_places(strains, {0.05, 0.10, 0.15, 0.20}, 0.02),
            (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_TRUE(nearest_places({}, {0.05}, 1.0).empty());
}

TEST(NearestPlaces, NameNoFrameTwice)
{
  EXPECT_EQ(nearest_places({0.0, 0.125}, {0.10, 0.15}, 0.03), (std::vector<std::size_t>{1}));
}

TEST(NearestPlaces, LeaveOutAStrainThatNoFrameIsNear)
{
  EXPECT_EQ(nearest_places({0.0, 0.01, 0.1}, {0.05, 0.10}, 0.02), (std::vector<std::size_t>{2}));
}
