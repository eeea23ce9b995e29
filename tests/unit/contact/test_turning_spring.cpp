// SPDX-License-Identifier: GPL-2.0-only
#include "contact/resolve_contact.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace encased_column;

namespace {

const Vec3 x_axis(1.0, 0.0, 0.0), y_axis(0.0, 1.0, 0.0), z_axis(0.0, 0.0, 1.0);

Mat3 rotation(double angle, const Vec3& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// `vector` carried along while the normal turns by `angle` about `axis` in `steps` steps.
Vec3 carried(Vec3 vector, Vec3 normal, double angle, const Vec3& axis, int steps)
{
  for (int step = 1; step <= steps; ++step)
    vector = laid_into_plane(vector, rotation(angle * step / steps, axis) * normal);
  return vector;
}

}  // namespace

TEST(LaidIntoPlane, KeepsTheLengthAndStaysInThePlane)
{
  const Vec3 vector(0.0, 3.0, -4.0);
  for (double angle = 0.0; angle < 1.0; angle += 0.05) {
    const Vec3 normal = rotation(angle, {0.3, 0.2, 0.9}) * x_axis;
    const Vec3 laid = laid_into_plane(vector, normal);
    EXPECT_NEAR(laid.norm(), 5.0, 4e-15);
    EXPECT_NEAR(laid.dot(normal), 0.0, 4e-15);
  }
}

TEST(LaidIntoPlane, LeavesWhatLiesInItToTheLastBit)
{
  const Vec3 vector(0.0, 0.1, -0.7);
  EXPECT_EQ(laid_into_plane(vector, x_axis), vector);
  EXPECT_EQ(laid_into_plane(Vec3::Zero(), x_axis), Vec3(0.0, 0.0, 0.0));
}

TEST(LaidIntoPlane, NeverMakesLongerWhatThePlaneTurnedInto)
{
  const Vec3 laid = laid_into_plane({1.0, 1e-9, 0.0}, x_axis);
  EXPECT_LE(laid.norm(), 2.1e-9);
}

// A great circle: the part across the way turns with the normal, the part along its axis stays.
TEST(LaidIntoPlane, FollowsAQuarterOfAGreatCircle)
{
  const Vec3 end = carried({0.0, 1.0, 2.0}, x_axis, pi / 2.0, z_axis, 20000);
  EXPECT_NEAR((end - Vec3(-1.0, 0.0, 2.0)).norm(), 0.0, 1.5e-4);
  EXPECT_NEAR(end.norm(), std::sqrt(5.0), 1e-11);
}

TEST(LaidIntoPlane, ComesBackFromAFullTurnOfTheNormal)
{
  const Vec3 start(0.0, 1.0, 2.0);
  const double error = (carried(start, x_axis, 2.0 * pi, z_axis, 20000) - start).norm();
  EXPECT_LT(error, 2e-3);
  // Its error is of the first order.
  EXPECT_NEAR((carried(start, x_axis, 2.0 * pi, z_axis, 40000) - start).norm() / error, 0.5, 1e-2);
}

// Parallel transport around an octant of the sphere turns by the solid angle, pi / 2.
TEST(LaidIntoPlane, ComesBackTurnedByTheSolidAngleTheNormalWentAround)
{
  const int steps = 20000;
  Vec3 vector = y_axis;
  vector = carried(vector, x_axis, pi / 2.0, z_axis, steps);
  vector = carried(vector, y_axis, pi / 2.0, x_axis, steps);
  vector = carried(vector, z_axis, pi / 2.0, y_axis, steps);
  EXPECT_NEAR((vector - z_axis).norm(), 0.0, 2e-4);
}

TEST(HalfTurn, KeepsTheLengthAtAnySpin)
{
  const Vec3 vector(0.0, 3.0, -4.0);
  for (const double angle : {0.0, 1e-9, 0.1, 1.9, 4.1, -30.0, 1e6})
    EXPECT_NEAR(half_turn(angle).of(vector, x_axis).norm(), 5.0, 4e-15) << "at " << angle;
}

TEST(HalfTurn, TwiceIsTheWholeAngle)
{
  const double angle = 0.01;
  const Turn half = half_turn(angle);
  const Vec3 turned = half.of(half.of(y_axis, x_axis), x_axis);
  EXPECT_NEAR((turned - Vec3(0.0, std::cos(angle), std::sin(angle))).norm(), 0.0,
              1.01 * std::pow(angle, 3) / 48.0);
}

TEST(HalfTurn, ComesBackFromAFullTurnAboutTheNormal)
{
  const int steps = 20000;
  const Turn half = half_turn(2.0 * pi / steps);
  Vec3 vector(0.0, 3.0, -4.0);
  for (int step = 0; step < 2 * steps; ++step) vector = half.of(vector, x_axis);
  EXPECT_NEAR((vector - Vec3(0.0, 3.0, -4.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(vector.norm(), 5.0, 1e-10);
}

// A spring k on a mass m that turns by `angle` a step: with the half turns its rule of a step has
// the determinant of a rotation and real traces, so the motion stays bounded at every spin, up to
// a step of sqrt(2 + 2 cos(half angle)) sqrt(m / k).
TEST(HalfTurn, NeitherFeedsNorDampsATurningSpring)
{
  for (const double angle : {1e-3, 0.1, 1.0, 1.9, 4.1, -4.1}) {
    const Turn half = half_turn(angle);
    const double ratio = 1.8 * 0.6;  // k dt^2 / m
    Vec3 spring(0.0, 1.0, 0.0), way = Vec3::Zero();
    double largest = 0.0;
    for (int step = 0; step < 100000; ++step) {
      way -= ratio * spring;
      spring = half.of(half.of(spring, x_axis) + way, x_axis);
      if (step > 50000) largest = std::max(largest, spring.norm());
    }
    EXPECT_LT(largest, 4.0) << "at " << angle;
    EXPECT_GT(largest, 0.5) << "at " << angle;
  }
}

namespace {

/// Two grains, or a grain and a wall, that turn together as one rigid body with loaded springs.
class RigidTurn : public ::testing::TestWithParam<bool> {
 protected:
  /// After the turn by `angle` about `axis` in `steps` steps: shear spring and rolling torque.
  std::array<Vec3, 2> springs_after(double angle, const Vec3& axis, int steps)
  {
    const double dt = 1e-3;
    const Vec3 spin = (angle / (steps * dt)) * axis.normalized();
    const double r_i = 0.007, r_j = GetParam() ? 0.0 : 0.003, overlap = 1e-4;
    const double distance = r_i + r_j - overlap;
    std::array<double, memory_size_rolling> memory{0.0, 3e-7, -4e-7, 0.0, 0.0, 2e-4, 1e-4};
    for (int step = 1; step <= steps; ++step) {
      const Vec3 normal = rotation(angle * step / steps, axis) * x_axis;
      const Vec3 velocity = spin.cross(distance * normal);
      const Touch touch{overlap, normal, 1.0, {r_i, Vec3::Zero(), spin}, {r_j, velocity, spin}};
      // The point of a wall that touches lies at the end of the arm.
      Touch at_contact = touch;
      if (GetParam()) at_contact.j.velocity = spin.cross(contact_arm(r_i, overlap) * normal);
      resolve_contact<true>({7e6, 2.0, 0.5, 0.0, 0.0, 0.5}, at_contact, dt, step, true,
                            memory.data());
    }
    return {Vec3(memory[0], memory[1], memory[2]), Vec3(memory[4], memory[5], memory[6])};
  }

  void expect_turned(double angle, const Vec3& axis)
  {
    const Mat3 turn = rotation(angle, axis);
    const auto [spring, torque] = springs_after(angle, axis, 20000);
    EXPECT_NEAR((spring - turn * Vec3(0.0, 3e-7, -4e-7)).norm() / 5e-7, 0.0, 5e-4);
    EXPECT_NEAR((torque - turn * Vec3(0.0, 2e-4, 1e-4)).norm() / std::hypot(2e-4, 1e-4), 0.0, 5e-4);
    EXPECT_NEAR(spring.norm() / 5e-7, 1.0, 1e-9);
    EXPECT_NEAR(torque.norm() / std::hypot(2e-4, 1e-4), 1.0, 1e-9);
  }
};

}  // namespace

TEST_P(RigidTurn, CarriesBothSpringsAboutTheNormal)
{
  expect_turned(1.7, x_axis);
}

TEST_P(RigidTurn, CarriesBothSpringsWithTheNormal)
{
  expect_turned(1.7, z_axis);
}

TEST_P(RigidTurn, CarriesBothSpringsAboutAnyAxis)
{
  expect_turned(-2.9, {0.6, -0.3, 0.5});
}

INSTANTIATE_TEST_SUITE_P(OnGrainAndWall, RigidTurn, ::testing::Bool());
