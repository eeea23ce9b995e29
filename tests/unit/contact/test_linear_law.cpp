// SPDX-License-Identifier: GPL-2.0-only
#include "contact/linear_law.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

const Vec3 along_x(1.0, 0.0, 0.0);

/// Two bodies on one line that meet with `speed`, followed by velocity Verlet until they part:
/// mass, spring and dashpot alone.
struct Collision {
  double restitution, time, largest_overlap, largest_force, dashpot_loss;
};

Collision collide(double beta, double mass, double stiffness, double speed)
{
  const ContactMaterial material{1.0, 1.0, 0.0, beta, 0.0, 0.0};
  const ContactStiffness k{stiffness, stiffness};
  const double dt = 1e-4 * std::sqrt(mass / stiffness);
  Collision result{0.0, 0.0, 0.0, 0.0, 0.0};
  Vec3 spring = Vec3::Zero();
  double overlap = 0.0, closing = speed, before = 0.0;
  do {
    overlap += dt * (closing - 0.5 * dt * before / mass);
    const ContactForce f = linear_contact(material, k, overlap, mass, {closing, Vec3::Zero()},
                                          along_x, dt, true, spring);
    closing -= 0.5 * dt * (before + f.normal) / mass;
    before = f.normal;
    result.time += dt;
    result.largest_overlap = std::max(result.largest_overlap, overlap);
    result.largest_force = std::max(result.largest_force, f.normal);
    result.dashpot_loss += f.dashpot_loss;
  } while (before > 0.0);
  result.restitution = -closing / speed;
  return result;
}

}  // namespace

TEST(LinearStiffness, OfTwoEqualGrainsIsHalfPiTimesRadiusTimesModulus)
{
  const ContactMaterial material{7e6, 3.5, 0.0, 0.0, 0.0, 0.0};
  const ContactStiffness k = linear_stiffness(material, 0.01, 0.02);
  EXPECT_DOUBLE_EQ(k.normal, 0.5 * pi * 0.01 * 7e6);
  EXPECT_DOUBLE_EQ(k.shear, k.normal / 3.5);
}

TEST(LinearStiffness, AgainstAWallIsTwiceThatOfTwoEqualGrains)
{
  const ContactMaterial material{7e6, 1.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(linear_stiffness(material, 0.01, 0.01).normal,
                   2.0 * linear_stiffness(material, 0.01, 0.02).normal);
}

TEST(ContactVelocity, IsZeroWhenBothBodiesMoveAsOneRigidBody)
{
  const Vec3 n = Vec3(1.0, -2.0, 0.5).normalized();
  const Vec3 speed(0.3, 0.1, -0.7), spin(2.0, -5.0, 1.0);
  const double c_i = 0.013, c_j = 0.004;
  const Vec3 contact(0.2, 0.1, 0.3);
  const Vec3 v_i = speed + spin.cross(contact - c_i * n);
  const Vec3 v_j = speed + spin.cross(contact + c_j * n);
  const ContactVelocity v = contact_velocity(n, v_i, spin, c_i, v_j, spin, c_j);
  EXPECT_NEAR(v.closing, 0.0, 1e-15);
  EXPECT_NEAR(v.slip.norm(), 0.0, 1e-15);
}

TEST(ContactVelocity, HasNoSlipWhereABallRollsOnAPlane)
{
  const Vec3 down(0.0, 0.0, -1.0);
  const ContactVelocity v = contact_velocity(down, {0.5, 0.0, 0.0}, {0.0, 0.5 / 0.02, 0.0}, 0.02,
                                             Vec3::Zero(), Vec3::Zero(), 0.0);
  EXPECT_NEAR(v.slip.norm(), 0.0, 1e-15);
}

TEST(ContactVelocity, IsThatOfTheSurfacesWhenTheBodiesSpinTheSameWay)
{
  const Vec3 spin(0.0, 0.0, 3.0);
  const ContactVelocity v =
      contact_velocity(along_x, {2.0, 0.0, 0.0}, spin, 0.01, {-1.0, 0.0, 0.0}, spin, 0.02);
  EXPECT_DOUBLE_EQ(v.closing, 3.0);
  EXPECT_NEAR((v.slip - Vec3(0.0, 3.0 * 0.03, 0.0)).norm(), 0.0, 1e-16);
}

TEST(LinearContact, WithoutDashpotGivesTheHalfPeriodOfASpring)
{
  const double mass = 0.3, stiffness = 1e5, speed = 0.2;
  const Collision c = collide(0.0, mass, stiffness, speed);
  EXPECT_NEAR(c.time / (pi * std::sqrt(mass / stiffness)), 1.0, 1e-4);
  EXPECT_NEAR(c.largest_overlap / (speed * std::sqrt(mass / stiffness)), 1.0, 1e-7);
  EXPECT_NEAR(c.largest_force / (speed * std::sqrt(mass * stiffness)), 1.0, 1e-7);
  EXPECT_NEAR(c.restitution, 1.0, 1e-7);
}

// x'' + 2 b w x' + w^2 x = 0 ends where its force is zero, at w t sqrt(1 - b^2) = pi - 2 asin b:
// there the speed is exp(-b / sqrt(1 - b^2) (pi - 2 asin b)) of that before. Without the cut-off of
// tension the bracket would be pi.
TEST(LinearContact, WithDashpotGivesTheRestitutionOfAnOscillatorThatCannotPull)
{
  for (const double beta : {0.05, 0.2, 0.6}) {
    const double mass = 0.3, speed = 0.2;
    const Collision c = collide(beta, mass, 1e5, speed);
    const double expected =
        std::exp(-beta / std::sqrt(1.0 - beta * beta) * (pi - 2.0 * std::asin(beta)));
    EXPECT_NEAR(c.restitution, expected, 1e-3 * expected) << "at beta = " << beta;
    // What the dashpot took is what the bodies lost, except for the overlap left as the force ends.
    const double lost = 0.5 * mass * speed * speed * (1.0 - c.restitution * c.restitution);
    EXPECT_LT(c.dashpot_loss, lost);
  }
}

TEST(LinearContact, NeverPulls)
{
  const ContactMaterial material{1.0, 1.0, 0.5, 0.9, 0.0, 0.0};
  Vec3 spring(0.0, 1e-3, 0.0);
  const ContactForce f = linear_contact(material, {1e5, 1e5}, 1e-6, 1.0, {-10.0, Vec3::Zero()},
                                        along_x, 1e-5, true, spring);
  EXPECT_EQ(f.normal, 0.0);
  EXPECT_EQ(f.shear.norm(), 0.0) << "nothing presses, nothing rubs";
}

TEST(LinearContact, ShearsLikeASpringBelowCoulombsLimit)
{
  const ContactMaterial material{1.0, 1.0, 0.5, 0.0, 0.0, 0.0};
  Vec3 spring(0.0, 1e-5, 0.0);
  const ContactForce f = linear_contact(material, {2e5, 1e5}, 1e-3, 1.0, {0.0, {0.0, 0.0, 0.1}},
                                        along_x, 1e-4, true, spring);
  EXPECT_FALSE(f.sliding);
  EXPECT_DOUBLE_EQ(f.normal, 200.0);
  EXPECT_NEAR((spring - Vec3(0.0, 1e-5, 1e-5)).norm(), 0.0, 1e-18);
  EXPECT_NEAR((f.shear - Vec3(0.0, -1.0, -1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(f.friction_loss, 0.0);
}

TEST(LinearContact, SlidesAtFrictionTimesNormalForceAgainstTheSlip)
{
  const ContactMaterial material{1.0, 1.0, 0.5, 0.0, 0.0, 0.0};
  Vec3 spring = Vec3::Zero();
  const ContactForce f = linear_contact(material, {2e5, 1e5}, 1e-3, 1.0, {0.0, {0.0, -40.0, 30.0}},
                                        along_x, 1e-3, true, spring);
  EXPECT_TRUE(f.sliding);
  EXPECT_NEAR((f.shear - 100.0 * Vec3(0.0, 0.8, -0.6)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(1e5 * spring.norm(), 100.0, 1e-12);
}

// A step of 50 mm from a spring at rest: 1 mm is kept, 49 mm are slid, while the force grows from
// zero to 100 N; its mean times the slide is lost.
TEST(LinearContact, LosesTheMeanForceTimesTheWaySlid)
{
  const ContactMaterial material{1.0, 1.0, 0.5, 0.0, 0.0, 0.0};
  Vec3 spring = Vec3::Zero();
  const ContactForce f = linear_contact(material, {2e5, 1e5}, 1e-3, 1.0, {0.0, {0.0, 50.0, 0.0}},
                                        along_x, 1e-3, true, spring);
  EXPECT_NEAR(f.friction_loss, 50.0 * 0.049, 1e-12);
}

TEST(LinearContact, TurnsTheWorkOfShearIntoStoredAndLostEnergyToRoundOff)
{
  const ContactMaterial material{1.0, 1.0, 0.3, 0.0, 0.0, 0.0};
  const ContactStiffness k{2e5, 7e4};
  Vec3 spring = Vec3::Zero(), before = Vec3::Zero();
  double work = 0.0, lost = 0.0;
  const double dt = 1e-3, overlap = 1e-3;
  for (int step = 0; step < 400; ++step) {
    const double phase = 0.05 * step;
    const Vec3 slip(0.0, std::cos(phase), std::sin(2.0 * phase) + 0.3);
    const ContactForce f =
        linear_contact(material, k, overlap, 1.0, {0.0, slip}, along_x, dt, true, spring);
    work -= 0.5 * (before + f.shear).dot(slip) * dt;
    lost += f.friction_loss;
    before = f.shear;
  }
  const double stored = spring_energy(k, overlap, spring) - spring_energy(k, overlap, Vec3::Zero());
  EXPECT_GT(lost, 10.0 * stored);
  EXPECT_NEAR(work, stored + lost, 1e-12 * work);
}

TEST(LinearContact, LaysItsSpringIntoTheContactPlaneAtItsLength)
{
  const ContactMaterial material{1.0, 1.0, 10.0, 0.0, 0.0, 0.0};
  Vec3 spring(3e-4, 4e-4, 0.0);
  linear_contact(material, {1e5, 1e5}, 1e-3, 1.0, {0.0, Vec3::Zero()}, along_x, 1e-4, true, spring);
  EXPECT_NEAR((spring - Vec3(0.0, 5e-4, 0.0)).norm(), 0.0, 1e-18);
}

TEST(LinearContact, LeavesItsMemoryAloneUnlessItAdvances)
{
  const ContactMaterial material{1.0, 1.0, 0.1, 0.1, 0.1, 0.0};
  const Vec3 before(1e-5, 2e-3, 0.0);
  Vec3 spring = before;
  const ContactForce f = linear_contact(material, {1e5, 1e5}, 1e-4, 1.0, {1.0, {0.0, 1.0, 0.0}},
                                        along_x, 1e-2, false, spring);
  EXPECT_EQ(spring, before);
  EXPECT_EQ(f.friction_loss, 0.0);
  EXPECT_EQ(f.dashpot_loss, 0.0);
}

TEST(LinearContact, GivesTheForceOfItsSpringAsItIsUnlessItAdvances)
{
  const ContactMaterial material{1.0, 1.0, 10.0, 0.0, 0.0, 0.0};
  Vec3 spring(0.0, 2e-4, 0.0);
  const ContactForce f = linear_contact(material, {1e5, 1e5}, 1e-3, 1.0, {0.0, {0.0, 1.0, 0.0}},
                                        along_x, 1e-4, false, spring);
  EXPECT_NEAR((f.shear - Vec3(0.0, -20.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(LinearContact, ShearDashpotTakesItsForceTimesTheSlip)
{
  const ContactMaterial material{1.0, 1.0, 10.0, 0.0, 0.2, 0.0};
  const double mass = 0.4, stiffness = 1e5, dt = 1e-5;
  Vec3 spring = Vec3::Zero();
  const ContactForce f = linear_contact(material, {stiffness, stiffness}, 1e-3, mass,
                                        {0.0, {0.0, 0.1, 0.0}}, along_x, dt, true, spring);
  const double dashpot = 2.0 * 0.2 * std::sqrt(mass * stiffness) * 0.1;
  EXPECT_NEAR(f.shear.y(), -stiffness * 0.1 * dt - dashpot, 1e-12);
  EXPECT_NEAR(f.dashpot_loss, dashpot * 0.1 * dt, 1e-15);
}

TEST(SpringEnergy, IsHalfStiffnessTimesSquareOfBothSprings)
{
  EXPECT_DOUBLE_EQ(spring_energy({2e5, 1e5}, 1e-3, {0.0, 3e-3, 4e-3}), 0.1 + 1.25);
}
