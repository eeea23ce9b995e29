// SPDX-License-Identifier: GPL-2.0-only
#include "contact/resolve_contact.h"

#include <gtest/gtest.h>

#include <array>

using namespace encased_column;

namespace {

using Memory = std::array<double, memory_size_rolling>;

const ContactMaterial material{7e6, 2.0, 0.5, 0.0, 0.0, 0.1};
const double dt = 1e-5;

/// Two grains of 10 and 6 mm that overlap by 0.1 mm and slip over one another.
Touch two_grains()
{
  const Vec3 n = Vec3(1.0, 2.0, -2.0) / 3.0;
  return {1e-4,
          n,
          0.002,
          {0.010, {0.1, 0.0, 0.2}, {1.0, 2.0, 3.0}},
          {0.006, {-0.1, 0.1, 0.0}, {0.0, -4.0, 1.0}}};
}

Touch grain_on_wall()
{
  Touch t = two_grains();
  t.j = {0.0, Vec3::Zero(), Vec3::Zero()};
  return t;
}

ContactAction resolve(const Touch& t, double step, bool advance, Memory& memory)
{
  return resolve_contact<true>(material, t, dt, step, advance, memory.data());
}

/// A memory as if the contact had been there, sheared and rolled, in step 99.
Memory memory_of_step_99()
{
  return {1e-5, 0.0, 0.5e-5, 99.0, 1e-3, 0.0, 5e-4};
}

}  // namespace

TEST(ResolveContact, TakesTheSmallerRadiusAndTheDistanceOfTheCenters)
{
  Memory memory{};
  const ContactAction action = resolve(two_grains(), 100.0, true, memory);
  EXPECT_DOUBLE_EQ(action.stiffness.normal, pi * 0.006 * 0.006 * 7e6 / 0.016);
  EXPECT_DOUBLE_EQ(action.stiffness.shear, action.stiffness.normal / 2.0);
  EXPECT_DOUBLE_EQ(action.normal_force, action.stiffness.normal * 1e-4);
}

TEST(ResolveContact, TakesTheGrainsRadiusTwiceAgainstAWall)
{
  Memory memory{};
  const ContactAction action = resolve(grain_on_wall(), 100.0, true, memory);
  EXPECT_DOUBLE_EQ(action.stiffness.normal, pi * 0.010 * 7e6);
}

TEST(ResolveContact, PressesTheGrainAwayFromTheOther)
{
  Memory memory{};
  const Touch t = two_grains();
  const ContactAction action = resolve(t, 100.0, true, memory);
  EXPECT_NEAR(action.force.dot(t.normal), -action.normal_force, 1e-12);
}

// The force on i acts at i, the opposite at j: its couple must be what the two moments undo. The
// rolling torque comes in a pair and adds nothing.
TEST(ResolveContact, KeepsTheAngularMomentumOfThePair)
{
  Memory memory{};
  const Touch t = two_grains();
  const ContactAction action = resolve(t, 100.0, true, memory);
  const double distance = t.i.radius + t.j.radius - t.overlap;
  const Vec3 couple = (distance * t.normal).cross(-action.force);
  EXPECT_GT(couple.norm(), 1e-6);
  EXPECT_NEAR((action.moment_i + action.moment_j + couple).norm(), 0.0, 1e-15);
}

TEST(ResolveContact, GoesOnFromTheMemoryOfTheStepBefore)
{
  const Touch t = two_grains();
  Memory still = memory_of_step_99(), fresh{};
  fresh[3] = 98.0;
  const double with = resolve(t, 100.0, true, still).force.dot(Vec3(1.0, 0.0, 0.5));
  const double without = resolve(t, 100.0, true, fresh).force.dot(Vec3(1.0, 0.0, 0.5));
  EXPECT_LT(with, without) << "the spring of step 99 pulls i back";
}

TEST(ResolveContact, StartsAnewWhenItWasNotThereOneStepAgo)
{
  const Touch t = two_grains();
  Memory stale = memory_of_step_99(), empty{};
  empty[3] = -1.0;
  const ContactAction after_a_gap = resolve(t, 101.0, true, stale);
  const ContactAction first = resolve(t, 101.0, true, empty);
  EXPECT_EQ(after_a_gap.force, first.force);
  EXPECT_EQ(after_a_gap.moment_i, first.moment_i);
  EXPECT_EQ(stale, empty);
}

TEST(ResolveContact, ReadsItsMemoryWithoutAChangeWhenItDoesNotAdvance)
{
  Memory memory = memory_of_step_99();
  const Memory before = memory;
  const ContactAction action = resolve(two_grains(), 99.0, false, memory);
  EXPECT_EQ(memory, before);
  EXPECT_EQ(action.friction_loss, 0.0);
  EXPECT_EQ(action.rolling_loss, 0.0);
}

TEST(ResolveContact, StoresTheEnergyOfItsThreeSprings)
{
  Memory memory{};
  const Touch t = two_grains();
  const ContactAction action = resolve(t, 100.0, true, memory);
  const double r = 0.010 * 0.006 / 0.016;
  const Vec3 spring(memory[0], memory[1], memory[2]), torque(memory[4], memory[5], memory[6]);
  EXPECT_NEAR(action.stored,
              0.5 * action.stiffness.normal * 1e-8 +
                  0.5 * action.stiffness.shear * spring.squaredNorm() +
                  0.5 * torque.squaredNorm() / (action.stiffness.shear * r * r),
              1e-15);
}

TEST(ResolveContact, WithoutRollingResistanceHasOnlyTheMomentsOfShear)
{
  Memory memory{};
  const Touch t = two_grains();
  const ContactAction action = resolve_contact<false>(material, t, dt, 100.0, true, memory.data());
  EXPECT_NEAR((action.moment_i * (0.006 - 5e-5) - action.moment_j * (0.010 - 5e-5)).norm(), 0.0,
              1e-18);
  EXPECT_EQ(action.rolling_loss, 0.0);
}
