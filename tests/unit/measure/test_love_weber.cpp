// SPDX-License-Identifier: GPL-2.0-only
#include "measure/seen_contact.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

// A grain pressed by F at both ends of its diameter d along z: V sigma_z = F d, nothing across.
TEST(LoveWeber, OfAGrainPressedFromTwoSidesIsForceTimesDiameter)
{
  const double radius = 0.01, force = 3.0;
  const Vec3 up = Vec3::UnitZ();
  double axial = 0.0, across = 0.0;
  for (const double side : {1.0, -1.0}) {
    axial += love_weber(-side * force * up, side * radius * up, up);
    across += love_weber(-side * force * up, side * radius * up, Vec3::UnitX());
  }
  EXPECT_DOUBLE_EQ(axial, force * 2.0 * radius);
  EXPECT_EQ(across, 0.0);
}

// Uniform pressure p on a sphere, put together from many patches: p in every direction.
TEST(LoveWeber, OfASphereUnderPressureIsThePressure)
{
  const double radius = 0.02, pressure = 5e3, pi = std::acos(-1.0);
  const int rings = 400;
  double along = 0.0;
  for (int k = 0; k < rings; ++k) {
    const double theta = pi * (k + 0.5) / rings;
    for (int m = 0; m < 8; ++m) {
      const double angle = 2.0 * pi * m / 8;
      const Vec3 n(std::sin(theta) * std::cos(angle), std::sin(theta) * std::sin(angle),
                   std::cos(theta));
      const double area =
          2.0 * pi * radius * radius * std::sin(theta) * (pi / rings) / 8;  // of the patch
      along += love_weber(-pressure * area * n, radius * n, Vec3::UnitX());
    }
  }
  const double volume = 4.0 / 3.0 * pi * radius * radius * radius;
  EXPECT_NEAR(along / volume, pressure, 1e-4 * pressure);
}
