// SPDX-License-Identifier: GPL-2.0-only
#include "specimen/specimen.h"

#include "core/constants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

/// A platen of 2 m^2 that says what it was told.
struct StillPlaten : Platen {
  StillPlaten(bool top, double z, double speed, double force)
      : top_(top),
        z_(z),
        speed_(speed),
        force_(force)
  {
  }
  bool is_top() const override { return top_; }
  double height() const override { return z_; }
  double speed() const override { return speed_; }
  double force() const override { return force_; }
  double stress() const override { return force_ / 2.0; }
  double work() const override { return force_ * 1e-3; }

  bool top_;
  double z_, speed_, force_;
};

/// A cone about x = 0.1, y = 0.2: its radius is 1 m at z = 0 and grows by 0.1 m a metre.
struct Cone : LateralBoundary {
  static double radius(double z) { return 1.0 + 0.1 * z; }
  Vec3 axis() const override { return {0.1, 0.2, 0.0}; }
  double enclosed_volume(double low, double high) const override
  {
    const auto cube = [](double z) { return std::pow(radius(z), 3); };
    return pi / 0.3 * (cube(high) - cube(low));
  }
  double cross_section(double z) const override { return pi * radius(z) * radius(z); }
  double radius_at(double z) const override { return radius(z); }
  double confining_stress() const override { return 70.0; }
  double work() const override { return 5.0; }
  int count_outside(const double* centers, int count, double low, double high) const override
  {
    int outside = 0;
    for (const double* x = centers; x != centers + 3 * count; x += 3)
      outside += x[2] < low || x[2] > high || std::hypot(x[0] - 0.1, x[1] - 0.2) > radius(x[2]);
    return outside;
  }
};

struct ASpecimen : testing::Test {
  StillPlaten top{true, 6.0, 0.3, 620.0}, bottom{false, 2.0, -0.1, 600.0};
  Cone cone;
  Specimen specimen{{&top, &bottom}, cone};
};

}  // namespace

TEST_F(ASpecimen, StandsBetweenItsPlatens)
{
  EXPECT_EQ(specimen.window().low, 2.0);
  EXPECT_EQ(specimen.window().high, 6.0);
  EXPECT_EQ(specimen.height(), 4.0);
  top.z_ = 5.0;
  EXPECT_EQ(specimen.height(), 3.0) << "it looks when it is asked";
}

// Frustum of radii 1.2 and 1.6 m: pi h (a^2 + a b + b^2) / 3.
TEST_F(ASpecimen, HasTheVolumeOfItsBoundaryBetweenThePlatens)
{
  EXPECT_NEAR(specimen.volume(), pi * 4.0 * (1.44 + 1.92 + 2.56) / 3.0, 1e-12);
}

TEST_F(ASpecimen, SaysItsStateWithRadiiAtTheQuarters)
{
  const SpecimenState s = specimen.state();
  EXPECT_EQ(s.height, 4.0);
  EXPECT_EQ(s.volume, specimen.volume());
  EXPECT_DOUBLE_EQ(s.radius[0], 1.3);
  EXPECT_DOUBLE_EQ(s.radius[1], 1.4);
  EXPECT_DOUBLE_EQ(s.radius[2], 1.5);
  EXPECT_EQ(s.stress_top, 310.0);
  EXPECT_EQ(s.stress_bottom, 300.0);
  EXPECT_EQ(s.confining_stress, 70.0);
}

// One platen comes at 0.3 m/s, the other goes at 0.1 m/s.
TEST_F(ASpecimen, IsShortenedByWhatBothPlatensGo)
{
  EXPECT_DOUBLE_EQ(specimen.axial_strain_rate(), 0.2 / 4.0);
  EXPECT_DOUBLE_EQ(specimen.platens().work(), 1.22);
}

TEST_F(ASpecimen, PointsOutwardAcrossItsCenterLine)
{
  const Vec3 out = specimen.outward({0.1 + 0.3, 0.2 - 0.4, 5.5});
  EXPECT_NEAR((out - Vec3(0.6, -0.8, 0.0)).norm(), 0.0, 1e-15);
}

TEST_F(ASpecimen, CountsTheGrainsThatAreNotInIt)
{
  const double centers[] = {0.1, 0.2, 3.0,   // on its axis
                            0.1, 0.2, 1.9,   // below
                            0.1, 0.2, 6.1,   // above
                            1.6, 0.2, 5.5,   // inside 1.55 m
                            1.6, 0.2, 4.0};  // outside 1.4 m
  EXPECT_EQ(specimen.count_outside(centers, 5), 3);
}

TEST(HeightWindow, DividesItsHeight)
{
  const HeightWindow window{2.0, 8.0};
  EXPECT_EQ(window.height(), 6.0);
  EXPECT_EQ(window.level(0.25), 3.5);
  const HeightWindow middle = window.middle_third();
  EXPECT_DOUBLE_EQ(middle.low, 4.0);
  EXPECT_DOUBLE_EQ(middle.high, 6.0);
  EXPECT_TRUE(middle.holds(5.0));
  EXPECT_FALSE(middle.holds(3.0));
  EXPECT_FALSE(middle.holds(6.5));
  EXPECT_TRUE(HeightWindow().holds(-1e300)) << "all heights";
}

// Spheres of 1 m in 8 m: the outer two touch the ends, the others stand evenly in between.
TEST(HeightWindow, StacksSpheresFromEndToEnd)
{
  const HeightWindow window{2.0, 10.0};
  EXPECT_EQ(window.level_in_stack(0, 3, 1.0), 3.0);
  EXPECT_EQ(window.level_in_stack(1, 3, 1.0), 6.0);
  EXPECT_EQ(window.level_in_stack(2, 3, 1.0), 9.0);
  EXPECT_EQ(window.level_in_stack(0, 1, 1.0), 6.0) << "a single one half way up";
}

TEST(RadiusOfSection, IsThatOfTheCircle)
{
  EXPECT_DOUBLE_EQ(radius_of_section(pi * 0.05 * 0.05), 0.05);
}

TEST(Shortening, IsPositiveInCompression)
{
  EXPECT_DOUBLE_EQ(shortening(0.2, 0.16), 0.2);
  EXPECT_DOUBLE_EQ(shortening(0.05, 0.055), -0.1);
}

TEST(MeanAndDeviatoricStress, SplitAnAxisymmetricStress)
{
  EXPECT_DOUBLE_EQ(mean_stress(250e3, 100e3), 150e3);
  EXPECT_DOUBLE_EQ(deviatoric_stress(250e3, 100e3), 150e3);
  // sigma_1 = p + 2 q / 3 whatever the two are
  EXPECT_DOUBLE_EQ(mean_stress(310e3, 70e3) + 2.0 / 3.0 * deviatoric_stress(310e3, 70e3), 310e3);
}

TEST(Porosity, OfASphereInItsCubeIsThatOfTheSimpleCubicLattice)
{
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(porosity(pi / 6.0, 1.0), 0.476401, 5e-7);
}
