// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/grain_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace encased_column;

namespace {

/// Grains on springs to the origin, more than two rows of them.
struct Swarm {
  static constexpr int count = 150;
  std::vector<double> x, v, w, f, m, radius, mass;
  std::vector<int> mask;
  MassScaling masses;
  GrainMotion motion;

  Swarm()
      : x(3 * count),
        v(x),
        w(x),
        f(x),
        m(x),
        radius(count, 0.1),
        mass(count, 2.0),
        mask(count, 1)
  {
    for (int k = 0; k < 3 * count; ++k) {
      x[k] = std::sin(1.0 + k);
      v[k] = std::cos(2.0 * k);
      w[k] = std::sin(3.0 * k);
    }
    masses.inertial_masses().assign(count, 2.0);
    motion.damping = 0.3;
  }

  StepGrains grains(bool all = true)
  {
    return {{v.data(), w.data(), radius.data(), mass.data(), count},
            x.data(),
            f.data(),
            m.data(),
            all ? nullptr : mask.data(),
            1};
  }
  void step(bool watched)
  {
    motion.begin_step(grains(), masses, 0.05, Vec3::Zero(), nullptr);
    for (int k = 0; k < 3 * count; ++k) {
      f[k] = -x[k];
      m[k] = -0.01 * w[k];
    }
    motion.end_step();
    if (watched) motion.complete_step(grains(), masses, 0.05);
  }
};

}  // namespace

TEST(GrainMotion, GoesTheSameWayInOnePassAsInTwo)
{
  Swarm one, two;
  for (int n = 0; n < 50; ++n) {
    one.step(n == 49);
    two.step(true);
  }
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.v, two.v);
  EXPECT_EQ(one.w, two.w);
  EXPECT_NEAR(one.motion.loss, two.motion.loss, 1e-12 * two.motion.loss);
  EXPECT_GT(one.motion.loss, 0.0);
}

TEST(GrainMotion, CompletesAStepOnce)
{
  Swarm swarm;
  swarm.step(true);
  const std::vector<double> v = swarm.v;
  swarm.motion.complete_step(swarm.grains(), swarm.masses, 0.05);
  EXPECT_EQ(swarm.v, v);
}

TEST(GrainMotion, LeavesGrainsOutsideTheGroupAlone)
{
  Swarm swarm;
  const std::vector<double> before = swarm.x;
  for (int i = 0; i < Swarm::count; i += 3) swarm.mask[i] = 2;
  swarm.motion.begin_step(swarm.grains(false), swarm.masses, 0.05, Vec3::Zero(), nullptr);
  for (int k = 0; k < 3 * Swarm::count; ++k)
    EXPECT_EQ(swarm.x[k] == before[k], k / 3 % 3 == 0) << "component " << k;
}

TEST(GrainMotion, StartsTheNextSumsWithTheWeightOfTheTrueMass)
{
  Swarm swarm;
  swarm.masses.inertial_masses()[7] = 50.0;
  const Vec3 g(0.0, 0.0, -9.81);
  swarm.f.assign(swarm.f.size(), 1.0);
  swarm.motion.begin_step(swarm.grains(), swarm.masses, 0.05, g, &g);
  for (int k = 0; k < 3 * Swarm::count; ++k) {
    EXPECT_EQ(swarm.f[k], k % 3 == 2 ? -2.0 * 9.81 : 0.0);
    EXPECT_EQ(swarm.m[k], 0.0);
  }
}
