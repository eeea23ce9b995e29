// SPDX-License-Identifier: GPL-2.0-only
#include "packing/placement.h"

#include "core/constants.h"
#include "core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace encased_column;

namespace {

const Cylinder specimen{0.05, 0.01, 0.21};

/// `count` radii from `high` down to `low` in equal ratios.
std::vector<double> radii_between(double low, double high, int count)
{
  std::vector<double> radii;
  for (int i = 0; i < count; ++i) radii.push_back(high * std::pow(low / high, i / (count - 1.0)));
  return radii;
}

}  // namespace

TEST(PlaceSpheres, LeavesNoOverlapBetweenAnyTwo)
{
  const std::vector<double> radii = radii_between(0.0005, 0.0075, 1500);
  const std::vector<Vec3> centers = place_spheres(radii, specimen, 1);
  ASSERT_EQ(centers.size(), radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE((centers[i] - centers[j]).norm(), (radii[i] + radii[j]) * (1.0 - 1e-12));
}

TEST(PlaceSpheres, KeepsEverySphereInsideTheCylinder)
{
  const std::vector<double> radii = radii_between(0.0005, 0.0075, 1500);
  const std::vector<Vec3> centers = place_spheres(radii, specimen, 2);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    EXPECT_LE(std::hypot(centers[i].x(), centers[i].y()) + radii[i], specimen.radius + 1e-15);
    EXPECT_GE(centers[i].z() - radii[i], specimen.z_low - 1e-15);
    EXPECT_LE(centers[i].z() + radii[i], specimen.z_high + 1e-15);
  }
}

// Points thrown evenly into a disc of radius R lie at 2/3 R on the mean, and at the mean height;
// standard deviations R / sqrt(18) and H / sqrt(12), the bounds are four of them.
TEST(PlaceSpheres, SpreadsSmallSpheresEvenly)
{
  const int count = 4000;
  const std::vector<Vec3> centers = place_spheres(std::vector<double>(count, 1e-5), specimen, 3);
  double radius = 0.0, height = 0.0, x = 0.0;
  for (const Vec3& c : centers) {
    radius += std::hypot(c.x(), c.y()) / count;
    height += (c.z() - specimen.z_low) / count;
    x += c.x() / count;
  }
  const double by = 4.0 / std::sqrt(count);
  EXPECT_NEAR(radius, 2.0 / 3.0 * 0.05, by * 0.05 / std::sqrt(18.0));
  EXPECT_NEAR(height, 0.1, by * 0.2 / std::sqrt(12.0));
  EXPECT_NEAR(x, 0.0, by * 0.05 / 2.0);
}

TEST(PlaceSpheres, IsTheSameForTheSameSeedOnly)
{
  const std::vector<double> radii = radii_between(0.001, 0.005, 200);
  EXPECT_EQ(place_spheres(radii, specimen, 5), place_spheres(radii, specimen, 5));
  EXPECT_NE(place_spheres(radii, specimen, 5), place_spheres(radii, specimen, 6));
}

TEST(PlaceSpheres, FillsACylinderThatHoldsJustOneSphere)
{
  const std::vector<Vec3> centers = place_spheres({0.05}, {0.05, 0.0, 0.1}, 1);
  EXPECT_NEAR((centers.at(0) - Vec3(0.0, 0.0, 0.05)).norm(), 0.0, 1e-15);
}

TEST(PlaceSpheres, OfNothingIsNothing)
{
  EXPECT_TRUE(place_spheres({}, specimen, 1).empty());
}

TEST(PlaceSpheres, RefusesASphereLargerThanTheCylinder)
{
  EXPECT_THROW(place_spheres({0.051}, specimen, 1), InputError);
  EXPECT_THROW(place_spheres({0.04}, {0.05, 0.0, 0.07}, 1), InputError);
}

TEST(PlaceSpheres, SaysWhichGrainFindsNoRoomWhenTheFactorIsTooLarge)
{
  // 60 % solids: random sequential addition of equal spheres jams at 38 %.
  const double radius = 0.005;
  const auto count = static_cast<std::size_t>(0.6 * specimen.volume() / (4.0 / 3.0 * pi * 1.25e-7));
  try {
    place_spheres(std::vector<double>(count, radius), specimen, 1);
    FAIL() << "placed 60 % solids";
  } catch (const InputError& problem) {
    const std::string found = problem.what();
    EXPECT_NE(found.find("'start_factor' leaves no room for grain "), std::string::npos) << found;
    EXPECT_NE(found.find(" of " + std::to_string(count)), std::string::npos) << found;
  }
}

TEST(Cylinder, VolumeIsThatOfTheSpecimen)
{
  EXPECT_NEAR(specimen.volume(), 1.5707963267948966e-3, 1e-15);
}
