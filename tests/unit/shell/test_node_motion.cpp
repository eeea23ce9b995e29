// SPDX-License-Identifier: GPL-2.0-only
#include "shell/node_motion.h"

#include "shell/rotation.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

#include <vector>

using namespace encased_column;

namespace {

constexpr int count = 13;  // no multiple of any vector
constexpr double dt = 1e-3;

struct TurningNodes {
  std::vector<Vec3> spin;
  std::vector<Quaternion> rotation;

  explicit TurningNodes(double size)
  {
    RandomVectors random(4);
    for (int n = 0; n < count; ++n) {
      spin.push_back(size * random());
      const Vec3 axis = random().normalized();
      rotation.emplace_back(Eigen::AngleAxisd(3.0 * random().x(), axis));
    }
  }
  bool turn()
  {
    return turn_nodes(spin.front().data(), count, dt, rotation.front().coeffs().data());
  }
};

}  // namespace

// Against Rodrigues' formula of the library, up to the largest angle of the series.
TEST(NodeMotion, TurnsNodesByTheirSpins)
{
  TurningNodes nodes(55.0), before = nodes;
  ASSERT_TRUE(nodes.turn());
  for (int n = 0; n < count; ++n) {
    const Vec3 turn = dt * before.spin[n];
    const Mat3 expected = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() *
                          before.rotation[n].toRotationMatrix();
    EXPECT_LT((nodes.rotation[n].toRotationMatrix() - expected).norm(), 1e-15 * 10.0)
        << "node " << n;
    EXPECT_NEAR(nodes.rotation[n].norm(), 1.0, 1e-15);
  }
}

TEST(NodeMotion, LeavesNodesThatTurnFarToOthers)
{
  TurningNodes nodes(10.0);
  nodes.spin[7] = Vec3(0.0, 101.0, 0.0);
  const TurningNodes before = nodes;
  EXPECT_FALSE(nodes.turn());
  for (int n = 0; n < count; ++n)
    EXPECT_EQ(nodes.rotation[n].coeffs(), before.rotation[n].coeffs());
}

// Cundall's damping: the force is a part alpha smaller where it drives the motion, larger where it
// brakes it; what the damping takes is its force times the mean velocity times the step.
TEST(NodeMotion, KicksNodesByTheirDampedLoads)
{
  const double alpha = 0.7;
  RandomVectors random(5);
  const int nodes = 3 * nodes_in_batch + 5;
  std::vector<Vec3> load, velocity;
  std::vector<double> inertia;
  for (int n = 0; n < nodes; ++n) {
    load.push_back(20.0 * random());
    velocity.push_back(n == 3 ? Vec3::Zero() : random());
    inertia.push_back(2.0 + random().x());
  }
  const std::vector<Vec3> before = velocity;
  const double work =
      kick_nodes(load.front().data(), inertia.data(), nodes, alpha, dt, velocity.front().data());
  double expected_work = 0.0;
  for (int n = 0; n < nodes; ++n)
    for (int a = 0; a < 3; ++a) {
      const double force = load[n](a), v = before[n](a);
      const double factor = v == 0.0 ? 1.0 : force * v > 0.0 ? 1.0 - alpha : 1.0 + alpha;
      const double now = v + dt * factor * force / inertia[n];
      EXPECT_NEAR(velocity[n](a), now, 1e-15);
      expected_work += (1.0 - factor) * force * 0.5 * (v + now) * dt;
    }
  EXPECT_NEAR(work, expected_work, 1e-14 * nodes);
}
