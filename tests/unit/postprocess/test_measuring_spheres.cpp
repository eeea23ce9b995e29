// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/inside_specimen.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

SphereSample sample(double strain, double height, double porosity)
{
  SphereSample sample{};
  sample.axial_strain = strain;
  sample.height = height;
  sample.porosity = porosity;
  return sample;
}

/// Two spheres, the upper one first, at three times.
std::vector<SphereSeries> two_spheres()
{
  return sphere_series({1, 2, 1, 2, 1, 2},
                       {sample(0.0, 0.16, 0.30), sample(0.0, 0.04, 0.20), sample(0.1, 0.14, 0.28),
                        sample(0.1, 0.04, 0.21), sample(0.2, 0.12, 0.26), sample(0.2, 0.04, 0.24)});
}

}  // namespace

TEST(MeasuringSpheres, StandFromTheLowestToTheHighest)
{
  const auto spheres = two_spheres();
  ASSERT_EQ(spheres.size(), 2u);
  EXPECT_EQ(over_time(spheres[0], &SphereSample::porosity),
            (std::vector<double>{0.20, 0.21, 0.24}));
  EXPECT_EQ(along_column(spheres, 1, &SphereSample::height), (std::vector<double>{0.04, 0.14}));
}

TEST(MeasuringSpheres, HaveTheMeanOfAllAtOneTime)
{
  EXPECT_DOUBLE_EQ(mean_of_spheres(two_spheres(), 2, &SphereSample::porosity), 0.25);
}

// A run still going on may have written the first sphere of a block only.
TEST(MeasuringSpheres, OfABlockThatWasCutOffAreLeftOut)
{
  const auto spheres = sphere_series(
      {1, 2, 1}, {sample(0.0, 0.04, 0.3), sample(0.0, 0.16, 0.3), sample(0.1, 0.04, 0.2)});
  ASSERT_EQ(spheres.size(), 2u);
  EXPECT_EQ(spheres[0].size(), 1u);
  EXPECT_EQ(spheres[1].size(), 1u);
}
