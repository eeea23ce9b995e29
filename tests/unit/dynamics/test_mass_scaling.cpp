// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/mass_scaling.h"

#include "dynamics/inertia.h"
#include "dynamics/kick_grains.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

/// Two grains of radius 1 m and 1 kg, the first moving and spinning, at a step of 1 s.
class ScaledGrains : public ::testing::Test {
 protected:
  ScaledGrains()
  {
    masses.rule = {1.0, 1.0, 0.0, false};
    masses.inertial_masses().resize(2);
    for (int i = 0; i < 2; ++i) masses.inertial_masses()[i] = 1.0;
    begin(false);
  }

  void begin(bool way_was_gone)
  {
    masses.begin_step({velocity, spin, radius, mass, 2}, way_was_gone);
    masses.clear_contacts();
  }
  /// A contact of the first grain with a wall that asks for `wanted` kg.
  void touch_wall(double wanted) { masses.raise_mass_for_contact(0, wanted, 0.1 * wanted); }

  double energy() const
  {
    return kinetic_energy(masses.inertial_mass(0), 1.0, as_vec3(velocity), as_vec3(spin));
  }
  Vec3 momentum() const { return masses.inertial_mass(0) * as_vec3(velocity); }
  Vec3 angular_momentum() const { return 0.4 * masses.inertial_mass(0) * as_vec3(spin); }

  double velocity[6] = {1.0, -2.0, 3.0, 0.0, 0.0, 0.0};
  double spin[6] = {0.5, 4.0, -1.0, 0.0, 0.0, 0.0};
  double radius[2] = {1.0, 1.0};
  double mass[2] = {1.0, 1.0};
  MassScaling masses;
};

}  // namespace

// Perfectly plastic impact with a mass at rest: of the energy the part m / m' is left.
TEST(ChangeInertia, OfABodyThatGetsHeavierKeepsItsMomentum)
{
  Vec3 velocity(3.0, 4.0, 0.0);
  double inertia = 2.0;
  EXPECT_DOUBLE_EQ(change_inertia(inertia, 8.0, velocity), 25.0 * (1.0 - 2.0 / 8.0));
  EXPECT_EQ(inertia, 8.0);
  EXPECT_EQ(velocity, Vec3(0.75, 1.0, 0.0));
}

// What is given off flies on beside the body and takes its part of the energy along.
TEST(ChangeInertia, OfABodyThatGetsLighterKeepsItsVelocity)
{
  Vec3 velocity(3.0, 4.0, 0.0);
  double inertia = 8.0;
  EXPECT_DOUBLE_EQ(change_inertia(inertia, 2.0, velocity), 100.0 * (1.0 - 2.0 / 8.0));
  EXPECT_EQ(inertia, 2.0);
  EXPECT_EQ(velocity, Vec3(3.0, 4.0, 0.0));
}

// A contact of k = 0.9 that opens for one step may close again long before masses are found once
// more. Central differences are stable while k dt^2 / m stays below 4 (Courant, Friedrichs and
// Lewy): at once back to 0.1 kg it would be 9.
TEST_F(ScaledGrains, StayHeavyEnoughForAContactThatClosesAgain)
{
  const double stiffness = 0.9;
  mass[0] = 0.1;
  masses.add_contact(0, -1, Vec3::UnitX(), stiffness, 0.1 * stiffness);
  masses.set_masses();
  const double touching = masses.inertial_mass(0);
  begin(false);
  masses.set_masses();  // it has just opened
  EXPECT_LT(masses.inertial_mass(0), touching);
  EXPECT_LT(stiffness / masses.inertial_mass(0), 4.0);
}

// Of 1 kg too much 0.98^n are left after n times.
TEST_F(ScaledGrains, GetRidOfMassInTime)
{
  masses.add_contact(0, -1, Vec3::UnitX(), 8.0, 0.8);
  masses.set_masses();
  const double touching = masses.inertial_mass(0);
  for (int n = 1; n <= 20; ++n) {
    begin(false);
    masses.set_masses();
    EXPECT_NEAR(masses.inertial_mass(0), touching * std::pow(0.98, n), 1e-13 * touching);
  }
  for (int n = 0; n < 200; ++n) masses.set_masses();
  EXPECT_EQ(masses.inertial_mass(0), 1.0);
}

TEST_F(ScaledGrains, KeepBothMomentaWhereTheyGetHeavierAndBookWhatTheyLose)
{
  const Vec3 linear = momentum(), angular = angular_momentum();
  const double before = energy();
  touch_wall(5.0);
  EXPECT_EQ(masses.inertial_mass(0), 5.0);
  EXPECT_LT((momentum() - linear).norm(), 1e-15 * linear.norm());
  EXPECT_LT((angular_momentum() - angular).norm(), 1e-15 * angular.norm());
  const double loss = masses.take_loss();
  EXPECT_NEAR(loss, before * (1.0 - 1.0 / 5.0), 1e-14 * before);
  EXPECT_NEAR(energy() + loss, before, 1e-14 * before);
  EXPECT_EQ(masses.take_loss(), 0.0);
}

TEST_F(ScaledGrains, KeepTheirVelocityWhereTheyGetLighterAndBookWhatTheyLose)
{
  masses.inertial_masses()[0] = 4.0;
  const double before = energy();
  for (int n = 0; n < 70; ++n) masses.set_masses();  // nothing touches the grain; 4 x 0.98^69 < 1
  EXPECT_EQ(masses.inertial_mass(0), 1.0);
  EXPECT_EQ(as_vec3(velocity), Vec3(1.0, -2.0, 3.0));
  EXPECT_EQ(as_vec3(spin), Vec3(0.5, 4.0, -1.0));
  EXPECT_NEAR(masses.take_loss(), 0.75 * before, 1e-14 * before);
}

// In the middle of a step the mass counts at once and the momentum is put right after the last half
// kick: the impulse counts in full, whatever the mass was.
TEST_F(ScaledGrains, GetTheWholeImpulseOfAStepInWhichTheyGetHeavier)
{
  begin(true);
  const Vec3 linear = momentum(), angular = angular_momentum();
  const double before = energy();
  touch_wall(4.0);
  touch_wall(3.0);  // asks for less than there is
  touch_wall(10.0);
  EXPECT_EQ(masses.inertial_mass(0), 10.0);
  double force[3] = {7.0, 0.0, -2.0}, moment[3] = {0.0, 3.0, 0.0};
  const GrainBatch row{velocity, spin, force, moment, radius, masses.inertial_masses().data(), 1};
  const double work = kick_grains(row, 0.0, 0.5).loss;
  EXPECT_EQ(work, 0.0);
  const double kicked = energy();
  masses.sort_raised();
  EXPECT_TRUE(masses.raised_before(1));
  EXPECT_FALSE(masses.raised_before(0));
  masses.settle();
  EXPECT_FALSE(masses.raised_before(2));
  EXPECT_LT((momentum() - linear - 0.5 * as_vec3(force)).norm(), 1e-14 * linear.norm());
  EXPECT_LT((angular_momentum() - angular - 0.5 * as_vec3(moment)).norm(), 1e-14 * angular.norm());
  // What was booked is the change of energy that is not the kick's.
  const double by_kick = kicked - before * 10.0;
  EXPECT_NEAR(masses.take_loss(), before + by_kick - energy(), 1e-13 * kicked);
}

// A mass on a spring, which is never lighter than its step asks for and up to six times as heavy.
TEST(MassScaling, ClosesTheAccountOfASpringWhoseMassChangesInEveryStep)
{
  double velocity[3] = {0.0, 0.0, 0.0}, spin[3] = {}, moment[3] = {}, radius = 0.1, mass = 1e-3;
  const double k = 1.0, dt = 1.0;
  MassScaling masses;
  masses.rule = {dt, 0.8, 0.0, false};
  masses.inertial_masses().resize(1);
  masses.inertial_masses()[0] = 2.0;
  double x = 1.0, loss = 0.0, force[3] = {-k * x, 0.0, 0.0};
  // Central differences keep the energy of a linear spring less dt^2 F^2 / (8 m).
  const double start = 0.5 * k - k * k * dt * dt / (8.0 * 2.0);
  unsigned random = 1;
  for (int step = 0; step < 1000; ++step) {
    const auto kick = [&] {
      kick_grains({velocity, spin, force, moment, &radius, masses.inertial_masses().data(), 1}, 0.0,
                  0.5 * dt);
    };
    kick();
    x += dt * velocity[0];
    force[0] = -k * x;
    masses.begin_step({velocity, spin, &radius, &mass, 1}, true);
    masses.clear_contacts();
    random = random * 1664525u + 1013904223u;
    masses.add_contact(0, -1, Vec3::UnitX(), k * (1.0 + (random >> 24) / 50.0), k);
    masses.set_masses();
    kick();
    masses.settle();
    loss += masses.take_loss();
    const double m = masses.inertial_mass(0);
    const double energy = 0.5 * m * velocity[0] * velocity[0] + 0.5 * k * x * x -
                          dt * dt * force[0] * force[0] / (8.0 * m);
    ASSERT_NEAR(energy + loss, start, 1e-12) << "in step " << step;
    ASSERT_LT(energy, 0.5 * k) << "energy from nowhere in step " << step;
  }
  EXPECT_GT(loss, 0.1);
}

TEST_F(ScaledGrains, AreAsHeavyAsTheirContactsAsk)
{
  masses.rule.stiffest_material = 2.0;
  masses.add_contact(0, 1, Vec3::UnitX(), 50.0, 1.0);
  const MassScaling::Found found = masses.set_masses();
  EXPECT_EQ(masses.inertial_mass(0), 50.0);
  EXPECT_EQ(masses.inertial_mass(1), 50.0);
  EXPECT_EQ(found.largest_factor, 50.0);
  EXPECT_DOUBLE_EQ(found.stable_step, 1.0);
  masses.clear_contacts();
  for (int n = 0; n < 200; ++n) masses.set_masses();  // one contact with something flat: pi r E*
  EXPECT_DOUBLE_EQ(masses.inertial_mass(0), 2.0 * std::acos(-1.0));
}

TEST_F(ScaledGrains, AreOfTheirTrueMassWithoutScaling)
{
  masses.rule.step = 0.0;
  masses.add_contact(0, 1, Vec3::UnitX(), 50.0, 1.0);
  touch_wall(90.0);
  EXPECT_DOUBLE_EQ(masses.set_masses().stable_step, std::sqrt(1.0 / 50.0));
  EXPECT_EQ(masses.inertial_mass(0), 1.0);
  EXPECT_EQ(masses.take_loss(), 0.0);
  EXPECT_EQ(as_vec3(velocity), Vec3(1.0, -2.0, 3.0));
}

TEST_F(ScaledGrains, ComeInAtTheSpeedTheyAreGiven)
{
  masses.rule.stiffest_material = 2.0;
  masses.inertial_masses()[0] = 0.0;
  masses.admit_new_grains();
  EXPECT_DOUBLE_EQ(masses.inertial_mass(0), 2.0 * std::acos(-1.0));
  EXPECT_EQ(masses.inertial_mass(1), 1.0) << "not new";
  EXPECT_EQ(as_vec3(velocity), Vec3(1.0, -2.0, 3.0));
  EXPECT_EQ(masses.take_loss(), 0.0);
}
