// SPDX-License-Identifier: GPL-2.0-only
#include "static_shell.h"

#include "core/constants.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace encased_column;

// A cantilever strip whose end is turned through a whole revolution rolls up into a circle (nu =
// 0): large turns with small strains. The free end comes back to the clamp, and both ends carry 2
// pi E I / L. Turned and not loaded: a moment about a fixed axis is not conservative out of the
// plane and makes the strip flutter (Ziegler), as it should.
TEST(RolledStrip, TurnedThroughARevolutionIsACircleWithTheMomentOfItsCurvature)
{
  const int along = 32, across = 2;
  const double length = 8.0, width = 0.5;
  ShellConstants c;
  c.modulus_hoop = 1e6;
  c.poisson = 0.0;
  c.thickness = 0.1;
  c.density = 1.0;
  SurfaceMesh mesh;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= along; ++i)
      mesh.node.emplace_back(length * i / along, width * j / across, 0.0);
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      const int a = i + (along + 1) * j, b = a + 1, d = a + along + 1, e = d + 1;
      mesh.facet.push_back({a, b, e});
      mesh.facet.push_back({a, e, d});
    }
  ShellModel model(mesh, c, Vec3::UnitY());
  for (int j = 0; j <= across; ++j) {
    model.support().push_back(clamped((along + 1) * j));
    Support end{along + (along + 1) * j};
    end.held_rotation = Mat3::Identity();
    model.support().push_back(end);
  }
  const long turning = 50000;
  for (const int quarter : {1, 2, 3, 4}) {
    const double angle = 0.5 * pi * quarter, r = length / angle;
    const auto turn_ends = [&](double speed) {
      for (Support& s : model.support())
        if (s.node % (along + 1) == along) s.angular_velocity.y() = -speed;
    };
    turn_ends(0.5 * pi / turning);
    relax(
        model, [](ShellModel&) {}, 0.0, turning);
    turn_ends(0.0);
    relax(
        model, [](ShellModel&) {}, 0.0, turning);
    const Vec3 tip = model.position()[2 * along + 1];
    const Vec3 expected(r * std::sin(angle), 0.5 * width, r * (1.0 - std::cos(angle)));
    double moment = 0.0;
    for (const Support& s : model.support())
      if (s.node % (along + 1) == along) moment -= s.moment.y();
    const double ratio = moment * r / (c.modulus_hoop * width * 1e-3 / 12.0);
    std::printf(
        "rolled strip, %d quarters of a circle: tip error %.4f L, moment / (E I / r) %.4f\n",
        quarter, (tip - expected).norm() / length, ratio);
    EXPECT_LT((tip - expected).norm(), 0.005 * length);
    EXPECT_NEAR(ratio, 1.0, 0.01);
  }
}
