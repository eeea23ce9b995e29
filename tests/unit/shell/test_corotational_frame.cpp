// SPDX-License-Identifier: GPL-2.0-only
#include "shell/corotational_frame.h"

#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

// By its definition, which only one decomposition meets: a turn times a symmetric, positive
// stretch.
TEST(CorotationalFrame, IsThePolarDecompositionOfTheDeformationGradient)
{
  RandomVectors random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::Matrix<double, 3, 2> gradient;
    gradient.col(0) = Vec3(1.0, 0.2, 0.1) + 0.5 * random();
    gradient.col(1) = Vec3(-0.1, 1.0, 0.3) + 0.5 * random();
    const CorotationalFrame frame(gradient.col(0), gradient.col(1));
    EXPECT_NEAR(frame.e1.norm(), 1.0, 1e-13);
    EXPECT_NEAR(frame.e2.norm(), 1.0, 1e-13);
    EXPECT_NEAR(frame.e1.dot(frame.e2), 0.0, 1e-13);
    EXPECT_NEAR((frame.u11 * frame.e1 + frame.u12 * frame.e2 - gradient.col(0)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((frame.u12 * frame.e1 + frame.u22 * frame.e2 - gradient.col(1)).norm(), 0.0, 1e-14);
    const double stretched_area = frame.u11 * frame.u22 - frame.u12 * frame.u12;
    EXPECT_GT(frame.u11, 0.0);
    EXPECT_GT(stretched_area, 0.0);
    EXPECT_NEAR((frame.e3 - frame.e1.cross(frame.e2)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(frame.area_ratio, stretched_area, 1e-14);
  }
}

TEST(DirectorTilt, OfASmallTurnIsTheTurn)
{
  const Vec3 turn(2e-4, -3e-4, 0.0);
  const DirectorTilt tilt(rotation_from_vector(turn) * Vec3::UnitZ());
  EXPECT_NEAR(tilt.x, turn.x(), 1e-11);
  EXPECT_NEAR(tilt.y, turn.y(), 1e-11);
}

TEST(DirectorTilt, OfALargeTurnIsTwiceTheTangentOfHalfTheAngle)
{
  const DirectorTilt tilt(rotation_from_vector(Vec3(0.0, 2.0, 0.0)) * Vec3::UnitZ());
  EXPECT_NEAR(tilt.x, 0.0, 1e-15);
  EXPECT_NEAR(tilt.y, 2.0 * std::tan(1.0), 1e-14);
}

TEST(DirectorTilt, DoesNotSeeATurnAboutTheDirectorItself)
{
  const Quaternion tilted = rotation_from_vector(Vec3(0.4, -0.3, 0.0));
  const DirectorTilt without(tilted * Vec3::UnitZ());
  const DirectorTilt with(tilted * rotation_from_vector(Vec3(0.0, 0.0, 2.0)) * Vec3::UnitZ());
  EXPECT_NEAR(with.x, without.x, 1e-15);
  EXPECT_NEAR(with.y, without.y, 1e-15);
}
