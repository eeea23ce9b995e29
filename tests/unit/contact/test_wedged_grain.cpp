// SPDX-License-Identifier: GPL-2.0-only
// A small grain wedged between a large one that is held and a frictionless wall: nothing drives it,
// so that its energy with all that is stored and lost may not grow, however it spins.
#include "contact/resolve_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

using namespace encased_column;

namespace {

using Memory = std::array<double, memory_size_rolling>;

/// As in a dense packing of stiff grains of 0.64 and 7.24 mm, in steps of 1 s with the mass scaled.
class WedgedGrain {
 public:
  static constexpr double small = 0.64e-3, large = 7.24e-3, mass = 4e6;
  const ContactMaterial grains{3e8, 2.0, 0.7, 0.0, 0.0, 0.5}, wall{3e8, 2.0, 0.0, 0.0, 0.0, 0.0};

  /// It spins by `turn` [rad a step] about the contact normal, and its rolling torque [N m] was
  /// loaded while the normal had another direction, 0.1 rad away.
  WedgedGrain(double turn, double torque)
  {
    const double overlap = 1.1e-3;
    const double press = linear_stiffness(grains, small, small + large).normal * overlap;
    wall_ = small - press / linear_stiffness(wall, small, small).normal;
    center_ = Vec3(small + large - overlap, 0.0, 0.0);
    wall_ += center_.x();
    spin_ = Vec3(turn, 0.0, 0.0);
    const Vec3 loaded = torque * Vec3(std::sin(0.1), std::cos(0.1), 0.0);
    with_grain_ = {0.0, 0.0, 0.0, 0.0, loaded.x(), loaded.y(), loaded.z()};
    with_wall_ = {};
    find_forces(0.0, false);
  }

  void step()
  {
    kick();
    center_ += velocity_;
    ++steps_;
    find_forces(steps_, true);
    kick();
  }
  double energy() const
  {
    return 0.5 * mass * velocity_.squaredNorm() + 0.5 * inertia * spin_.squaredNorm() + stored_ +
           lost_;
  }
  double spin_about_normal() const { return spin_.dot(center_.normalized()); }

 private:
  static constexpr double inertia = 0.4 * mass * small * small;

  void kick()
  {
    velocity_ += 0.5 / mass * force_;
    spin_ += 0.5 / inertia * moment_;
  }
  void find_forces(double step, bool advance)
  {
    const ContactBody body{small, velocity_, spin_};
    const double distance = center_.norm();
    const Touch grain{small + large - distance,
                      -center_ / distance,
                      mass,
                      body,
                      {large, Vec3::Zero(), Vec3::Zero()}};
    const Touch side{small - (wall_ - center_.x()),
                     Vec3(1.0, 0.0, 0.0),
                     mass,
                     body,
                     {0.0, Vec3::Zero(), Vec3::Zero()}};
    force_ = moment_ = Vec3::Zero();
    stored_ = 0.0;
    if (grain.overlap > 0.0) add(grains, grain, step, advance, with_grain_);
    if (side.overlap > 0.0) add(wall, side, step, advance, with_wall_);
  }
  void add(const ContactMaterial& material, const Touch& touch, double step, bool advance,
           Memory& memory)
  {
    const ContactAction a =
        resolve_contact<true>(material, touch, 1.0, step, advance, memory.data());
    force_ += a.force;
    moment_ += a.moment_i;
    stored_ += a.stored;
    lost_ += a.friction_loss + a.rolling_loss;
  }

  double wall_, stored_ = 0.0, lost_ = 0.0, steps_ = 0.0;
  Vec3 center_, velocity_ = Vec3::Zero(), spin_, force_, moment_;
  Memory with_grain_, with_wall_;
};

}  // namespace

/// Turn about the normal [rad a step] and rolling torque [N m]; its limit is 0.016 N m. Where the
/// torque is left in space its part along the normal makes up to 180 times the energy.
class WedgedGrainThatSpins : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(WedgedGrainThatSpins, GainsNoEnergy)
{
  const auto [turn, torque] = GetParam();
  WedgedGrain grain(turn, torque);
  const double start = grain.energy();
  double most = 0.0, least = start;
  for (int step = 0; step < 20000; ++step) {
    grain.step();
    most = std::max(most, grain.energy());
    least = std::min(least, grain.energy());
  }
  EXPECT_LT(most, 1.01 * start);
  EXPECT_GT(least, 0.99 * start);
  EXPECT_LE(std::abs(grain.spin_about_normal()), std::abs(turn) + 0.02);
}

INSTANTIATE_TEST_SUITE_P(, WedgedGrainThatSpins,
                         ::testing::Combine(::testing::Values(0.0, 0.01, 0.3, 2.0, -4.0),
                                            ::testing::Values(0.0, 0.004, 0.012)));
