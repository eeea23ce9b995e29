// SPDX-License-Identifier: GPL-2.0-only
#include "contact/rolling_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

using namespace encased_column;

namespace {

/// Contacts of all kinds: pairs and walls, sliding and sticking, new ones and old ones.
struct Contacts {
  std::vector<ContactMaterial> material;
  std::vector<Touch> touch;
  std::vector<std::array<double, memory_size_rolling>> memory;

  Contacts(int count, unsigned seed, bool dashpots)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0), both(-1.0, 1.0);
    const auto vector = [&](double size) {
      return Vec3(size * both(random), size * both(random), size * both(random));
    };
    for (int n = 0; n < count; ++n) {
      const bool wall = part(random) < 0.3;
      const double r_i = 1e-3 * (1.0 + 6.0 * part(random));
      const double r_j = wall ? 0.0 : 1e-3 * (1.0 + 6.0 * part(random));
      material.push_back({7e6 * (1.0 + part(random)), 0.5 + 3.0 * part(random),
                          part(random) < 0.1 ? 0.0 : part(random), dashpots ? part(random) : 0.0,
                          dashpots ? part(random) : 0.0,
                          part(random) < 0.2 ? 0.0 : 0.3 * part(random)});
      // A wall that gives way may be pressed in by more than the radius.
      const bool deep = wall && part(random) < 0.2;
      touch.push_back({deep ? r_i * (0.5 + part(random)) : 1e-5 + 1e-4 * part(random),
                       vector(1.0).normalized(),
                       dashpots ? 1e-3 * (0.1 + part(random)) : 0.0,
                       {r_i, vector(0.1), vector(50.0)},
                       {r_j, vector(0.1), wall ? Vec3(0.0, 0.0, 0.0) : vector(50.0)}});
      Vec3 spring = vector(1e-4 * part(random));
      spring -= spring.dot(touch.back().normal) * touch.back().normal;
      Vec3 torque = vector(1e-3 * part(random));
      torque -= torque.dot(touch.back().normal) * touch.back().normal;
      memory.push_back({spring.x(), spring.y(), spring.z(), part(random) < 0.2 ? 7.0 : 9.0,
                        torque.x(), torque.y(), torque.z()});
    }
  }
};

/// Largest difference of a row from the same contacts one by one, relative to the largest force,
/// moment and spring, over many packings.
template <typename Row>
void expect_the_same(bool advance, bool dashpots = false)
{
  constexpr bool rolling = std::is_same_v<Row, RollingBatch>;
  const double dt = 1e-5, step = 10.0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const int count = 1 + static_cast<int>(seed % ContactBatch::size);
    Contacts together(count, seed, dashpots), alone(count, seed, dashpots);
    Row row;
    for (int n = 0; n < count; ++n) {
      const Touch& t = together.touch[n];
      const double more = t.overlap > 2e-4 ? t.overlap : 0.0;
      row.add(n, n + 100, 0.5, together.material[n],
              (t.i.radius + t.j.radius - t.overlap + more) * t.normal, t.i, t.j, t.mass,
              together.memory[n].data(), more);
    }
    const double loss = row.resolve(dt, step, advance);
    if (advance) row.keep(step);
    double expected_loss = 0.0, expected_dashpots = 0.0, expected_rolling = 0.0, losses = 0.0;
    for (int n = 0; n < count; ++n) {
      const ContactAction one = resolve_contact<rolling>(alone.material[n], alone.touch[n], dt,
                                                         step, advance, alone.memory[n].data());
      expected_loss += 0.5 * one.friction_loss;
      expected_dashpots += 0.5 * one.dashpot_loss;
      expected_rolling += 0.5 * one.rolling_loss;
      losses +=
          std::abs(one.friction_loss) + std::abs(one.dashpot_loss) + std::abs(one.rolling_loss);
      // A dashpot may take the spring's force back to nearly nothing.
      const double force =
          std::max(one.force.norm(), one.stiffness.normal * alone.touch[n].overlap);
      const double moment = std::max(one.moment_i.norm(), force * alone.touch[n].i.radius);
      EXPECT_LE((row.force(n) - one.force).norm(), 1e-12 * force);
      EXPECT_LE((row.moment_i(n) - one.moment_i).norm(), 1e-12 * moment);
      EXPECT_LE(
          ((alone.touch[n].is_wall() ? row.moment_on_wall(n) : row.moment_j(n)) - one.moment_j)
              .norm(),
          1e-12 * moment);
      EXPECT_NEAR(row.normal_force(n), one.normal_force, 1e-12 * force);
      EXPECT_NEAR(row.stored_energy(n), one.stored, 1e-12 * one.stored);
      EXPECT_NEAR(row.stiffness(n).normal, one.stiffness.normal, 1e-14 * one.stiffness.normal);
      EXPECT_NEAR(row.stiffness(n).shear, one.stiffness.shear, 1e-14 * one.stiffness.shear);
      EXPECT_NEAR(row.arm_i(n), one.arm, 1e-17);
      EXPECT_EQ(row.is_sliding(n), one.sliding);
      for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(together.memory[n][a], alone.memory[n][a], 1e-12 * force / one.stiffness.shear);
      EXPECT_EQ(together.memory[n][3], alone.memory[n][3]);
      for (int a = memory_size; a < memory_size_rolling; ++a)
        EXPECT_NEAR(together.memory[n][a], alone.memory[n][a], 1e-12 * moment);
    }
    if (advance) {
      EXPECT_NEAR(loss, expected_loss, 1e-12 * losses);
      EXPECT_NEAR(row.dashpot_loss(), expected_dashpots, 1e-12 * losses);
      if constexpr (rolling) {
        EXPECT_NEAR(row.rolling_loss(), expected_rolling, 1e-12 * losses);
      }
    }
  }
}

}  // namespace

TEST(ContactBatch, GivesWhatContactsOneByOneGiveInThousandPackings)
{
  expect_the_same<ContactBatch>(true);
}

TEST(ContactBatch, GivesItInASetUpToo)
{
  expect_the_same<ContactBatch>(false);
}

TEST(ContactBatch, GivesItWithDashpots)
{
  expect_the_same<ContactBatch>(true, true);
  expect_the_same<ContactBatch>(false, true);
}

TEST(RollingBatch, GivesItWithDashpots)
{
  expect_the_same<RollingBatch>(true, true);
  expect_the_same<RollingBatch>(false, true);
}

TEST(RollingBatch, GivesWhatContactsOneByOneGiveInThousandPackings)
{
  expect_the_same<RollingBatch>(true);
}

TEST(RollingBatch, GivesItInASetUpToo)
{
  expect_the_same<RollingBatch>(false);
}

// A set-up repeats a step: not nearly, but to the last bit.
template <typename Row>
void expect_the_last_bit_repeated(bool dashpots = false)
{
  Contacts contacts(ContactBatch::size, 5, dashpots);
  Row row;
  std::vector<Vec3> force, moment;
  for (const bool advance : {true, false}) {
    row.clear();
    for (int n = 0; n < ContactBatch::size; ++n) {
      const Touch& t = contacts.touch[n];
      row.add(n, n, 1.0, contacts.material[n], (t.i.radius + t.j.radius - t.overlap) * t.normal,
              t.i, t.j, t.mass, contacts.memory[n].data());
    }
    row.resolve(1e-5, 10.0, advance);
    for (int n = 0; n < ContactBatch::size; ++n) {
      if (advance) {
        force.push_back(row.force(n));
        moment.push_back(row.moment_i(n));
      } else {
        EXPECT_EQ(row.force(n), force[n]);
        EXPECT_EQ(row.moment_i(n), moment[n]);
      }
    }
    if (advance) row.keep(10.0);
  }
}

TEST(ContactBatch, RepeatsTheForcesOfAStepToTheLastBit)
{
  expect_the_last_bit_repeated<ContactBatch>();
}

TEST(RollingBatch, RepeatsTheForcesOfAStepToTheLastBit)
{
  expect_the_last_bit_repeated<RollingBatch>();
}

// Round-off may put the center of a grain that just touches a wall beyond its radius.
TEST(ContactBatch, PressesWithNothingWhereRoundOffLeavesNoOverlap)
{
  std::array<double, memory_size> memory{0.0, 0.0, 0.0, -1.0};
  const double radius = 1e-3;
  const Vec3 normal(1.0, 0.0, 0.0);
  const ContactBody rest{radius, Vec3::Zero(), Vec3::Zero()};
  ContactBatch row;
  row.add(0, -1, 1.0, {7e6, 3.5, 0.8}, radius * (1.0 + 4e-16) * normal, rest,
          {0.0, Vec3::Zero(), Vec3::Zero()}, 0.0, memory.data());
  const double loss = row.resolve(1e-6, 10.0, true);
  row.keep(10.0);
  EXPECT_EQ(row.force(0), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(loss, 0.0);
  EXPECT_EQ(memory[0], 0.0);
}
