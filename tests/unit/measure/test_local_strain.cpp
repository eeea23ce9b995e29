// SPDX-License-Identifier: GPL-2.0-only
#include "measure/local_strain.h"

#include "core/constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace encased_column;

namespace {

constexpr double range = 0.012;  // m, some thirty neighbours

/// Grains of several sizes, thrown into a cube of 50 mm, moved by `displacement`.
std::vector<MovedGrain> grains_moved(const std::function<Vec3(const Vec3&)>& displacement)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<MovedGrain> grains;
  for (int n = 0; n < 600; ++n) {
    const Vec3 x = 0.05 * Vec3(part(random), part(random), part(random));
    grains.push_back({x, displacement(x), 2e-3 + 2e-3 * part(random)});
  }
  return grains;
}

std::vector<double> strains_of(const Mat3& f)
{
  const Vec3 shift(0.3, -0.2, 0.1);
  return local_deviatoric_strain(
      grains_moved([&](const Vec3& x) -> Vec3 { return f * x - x + shift; }), range);
}

void expect_everywhere(const std::vector<double>& strains, double expected, double tolerance)
{
  ASSERT_EQ(strains.size(), 600u);
  for (const double strain : strains) EXPECT_NEAR(strain, expected, tolerance);
}

Mat3 simple_shear(double gamma)
{
  Mat3 f = Mat3::Identity();
  f(0, 2) = gamma;
  return f;
}

Mat3 turned_by(double angle)
{
  return Eigen::AngleAxisd(angle, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

}  // namespace

// A cylinder shortened by e at constant volume: deviatoric strain e as long as e is small, 2/3 of
// the difference of axial and radial strain at any size.
TEST(LocalStrain, OfCompressionIsTwoThirdsOfTheDifferenceOfStrains)
{
  for (const double axial : {1e-6, 0.05, 0.20}) {
    const double radial = 1.0 / std::sqrt(1.0 - axial) - 1.0;
    const Mat3 f = Vec3(1.0 + radial, 1.0 + radial, 1.0 - axial).asDiagonal();
    expect_everywhere(strains_of(f), 2.0 / 3.0 * (axial + radial), 1e-10);
  }
  EXPECT_NEAR(2.0 / 3.0 * (1e-6 + 1.0 / std::sqrt(1.0 - 1e-6) - 1.0), 1e-6, 1e-11);
}

TEST(LocalStrain, OfCompressionFromAllSidesIsZero)
{
  expect_everywhere(strains_of(0.9 * Mat3::Identity()), 0.0, 1e-10);
}

// Small: gamma / sqrt(3). Any size: principal stretches sqrt(1 + gamma^2 / 4) +- gamma / 2 and 1.
TEST(LocalStrain, OfSimpleShearIsItsClosedForm)
{
  expect_everywhere(strains_of(simple_shear(1e-6)), 1e-6 / std::sqrt(3.0), 1e-11);
  const double gamma = 0.8, mean = std::sqrt(1.0 + 0.25 * gamma * gamma);
  const double stretch[3] = {mean + 0.5 * gamma, mean - 0.5 * gamma, 1.0};
  const double center = (2.0 * mean + 1.0) / 3.0;
  double squares = 0.0;
  for (const double s : stretch) squares += (s - center) * (s - center);
  expect_everywhere(strains_of(simple_shear(gamma)), std::sqrt(2.0 / 3.0 * squares), 1e-10);
}

// The symmetric part of the displacement gradient would see 2/3 (1 - cos) of it.
TEST(LocalStrain, DoesNotSeeARotation)
{
  for (const double angle : {0.01, 0.7, 3.0}) {
    expect_everywhere(strains_of(turned_by(angle)), 0.0, 1e-9);
    expect_everywhere(strains_of(turned_by(angle) * simple_shear(0.3)),
                      strains_of(simple_shear(0.3)).front(), 1e-9);
  }
}

// Two blocks that slide on one another: the band is as wide as the range on either side.
TEST(LocalStrain, IsThereOnlyNearTheSurfaceOnWhichBlocksSlide)
{
  const std::vector<MovedGrain> grains =
      grains_moved([](const Vec3& x) { return Vec3(x.z() > 0.025 ? 0.004 : 0.0, 0.0, 0.0); });
  const std::vector<double> strain = local_deviatoric_strain(grains, range);
  for (std::size_t n = 0; n < grains.size(); ++n) {
    const double away = std::abs(grains[n].position.z() - 0.025);
    if (away > range) {
      EXPECT_NEAR(strain[n], 0.0, 1e-10);
    } else if (away < 0.2 * range) {
      EXPECT_GT(strain[n], 0.1);
    }
  }
}

// One grain in three a fine that moves as it likes: it has its value but no say.
TEST(LocalStrain, IsNotThatOfRattlingFines)
{
  std::vector<MovedGrain> grains =
      grains_moved([](const Vec3& x) -> Vec3 { return simple_shear(0.3) * x - x; });
  const double expected = local_deviatoric_strain(grains, range).front();
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (std::size_t n = 0; n < grains.size(); n += 3) {
    grains[n].diameter = 1e-3;
    grains[n].displacement += 0.005 * Vec3(part(random), part(random), part(random));
  }
  expect_everywhere(local_deviatoric_strain(grains, 1.5 * range), expected, 1e-9);
}

// A grain has as much say as eight of half the diameter in its place.
TEST(LocalStrain, WeighsNeighboursByTheirVolume)
{
  std::vector<MovedGrain> large = grains_moved(
      [](const Vec3& x) -> Vec3 { return 40.0 * x.x() * x.z() * Vec3(1.0, 0.5, -0.3); });
  std::vector<MovedGrain> split;
  for (std::size_t n = 0; n < large.size(); ++n) {
    large[n].diameter = n % 2 == 0 ? 2e-3 : 1.2e-3;
    split.push_back(large[n]);
    if (n % 2 == 0)
      for (int part = 0; part < 8; ++part) {
        split.push_back(large[n]);
        split.back().diameter = 1e-3;
      }
    if (n % 2 == 0) split.erase(split.end() - 9);
  }
  const std::vector<double> one = local_deviatoric_strain(large, range),
                            other = local_deviatoric_strain(split, range);
  std::size_t next = 0;
  for (std::size_t n = 0; n < large.size(); ++n) {
    EXPECT_NEAR(other[next], one[n], 1e-10);
    next += n % 2 == 0 ? 8 : 1;
  }
}

TEST(LocalStrain, IsUnknownWhereNeighboursSpanNoVolume)
{
  std::vector<MovedGrain> plane;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) plane.push_back({0.004 * Vec3(i, j, 0.0), Vec3::Zero(), 3e-3});
  for (const double strain : local_deviatoric_strain(plane, range))
    EXPECT_EQ(strain, strain_unknown);
  plane.resize(1);
  EXPECT_EQ(local_deviatoric_strain(plane, range).front(), strain_unknown);
  EXPECT_TRUE(local_deviatoric_strain({}, range).empty());
}

TEST(MeanDiameter, ByVolumeIsThatOfTheGrainAMeanBitOfSolidLiesIn)
{
  // 8 grains of 1 mm and one of 2 mm share the volume evenly
  std::vector<MovedGrain> grains(9, {Vec3::Zero(), Vec3::Zero(), 1e-3});
  grains.back().diameter = 2e-3;
  EXPECT_DOUBLE_EQ(mean_diameter_by_volume(grains), 1.5e-3);
  EXPECT_EQ(mean_diameter_by_volume({}), 0.0);
}

// A wave that fits a periodic box: where in it the box begins cannot matter, so grains carried
// round by a third of it keep their strains, and no grain lacks neighbours at a border.
TEST(LocalStrain, InAPeriodicBoxIsTheSameWhereverItsBordersAre)
{
  const PeriodicBox box{Vec3::Zero(), Vec3::Constant(0.05), {true, true, false}};
  std::vector<MovedGrain> grains = grains_moved([](const Vec3& x) {
    return Vec3(0.0, 1e-3 * std::sin(2.0 * pi * x.x() / 0.05),
                1e-3 * std::cos(4.0 * pi * x.y() / 0.05));
  });
  const std::vector<double> strain = local_deviatoric_strain(grains, range, box);
  const std::vector<double> open = local_deviatoric_strain(grains, range);
  for (MovedGrain& grain : grains)
    grain.position = box.wrapped(grain.position + Vec3(0.0171, 0.0333, 0.0));
  const std::vector<double> again = local_deviatoric_strain(grains, range, box);
  int at_border = 0;
  for (std::size_t n = 0; n < strain.size(); ++n) {
    EXPECT_NEAR(again[n], strain[n], 1e-10);
    at_border += std::abs(open[n] - strain[n]) > 1e-6;
  }
  EXPECT_GT(at_border, 100) << "grains near a border that an open box gives another strain";
}
