// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/inertia.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(InertialNumber, IsRateTimesSizeOverTheSpeedOfPressureInTheGrains)
{
  // sqrt(p / rho) = 10 m/s: 1/s times 10 mm over 10 m/s
  EXPECT_DOUBLE_EQ(inertial_number(1.0, 0.01, 2000.0, 200e3), 1e-3);
}

TEST(InertialNumber, DoesNotDependOnTheSenseOfShear)
{
  EXPECT_EQ(inertial_number(-0.2, 0.01, 2000.0, 5e4), inertial_number(0.2, 0.01, 2000.0, 5e4));
}

TEST(InertialNumber, DoesNotChangeWhenTimeAndMassAreScaledTogether)
{
  const double s = 1e4;  // density scaling by s^2 makes the same run s times slower
  EXPECT_NEAR(inertial_number(0.1 / s, 0.01, 2000.0 * s * s, 5e4),
              inertial_number(0.1, 0.01, 2000.0, 5e4), 1e-18);
}
