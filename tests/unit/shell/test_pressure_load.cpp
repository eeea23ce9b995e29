// SPDX-License-Identifier: GPL-2.0-only
#include "shell/pressure_load.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/enclosed_volume.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const SurfaceMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0.1, 1.2, 0}, {0.3, 0.2, 0.9}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

double signed_volume(const SurfaceMesh& mesh)
{
  double six = 0.0;
  for (const Facet& f : mesh.facet)
    six += mesh.node[f[0]].dot(mesh.node[f[1]].cross(mesh.node[f[2]]));
  return six / 6.0;
}

std::vector<Vec3> pushed(const SurfaceMesh& mesh, double pressure, const HeightWindow& window = {})
{
  std::vector<Vec3> force(mesh.node.size(), Vec3::Zero());
  add_pressure(mesh.facet, mesh.node, 0, mesh.facet.size(), pressure, window, force);
  return force;
}

}  // namespace

TEST(PressureLoad, IsTheGradientOfPressureTimesVolume)
{
  const std::vector<Vec3> force = pushed(tetrahedron, 50e3);
  const double h = 1e-5;
  for (std::size_t i = 0; i < tetrahedron.node.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      SurfaceMesh up = tetrahedron, down = tetrahedron;
      up.node[i](axis) += h;
      down.node[i](axis) -= h;
      const double slope = (signed_volume(up) - signed_volume(down)) / (2.0 * h);
      EXPECT_NEAR(force[i](axis), 50e3 * slope, 1e-5);
    }
}

TEST(PressureLoad, OnAClosedSurfaceHasNoForceAndNoMoment)
{
  const std::vector<Vec3> force = pushed(tetrahedron, 50e3);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t i = 0; i < force.size(); ++i) {
    sum += force[i];
    moment += tetrahedron.node[i].cross(force[i]);
  }
  EXPECT_LT(sum.norm(), 1e-10);
  EXPECT_LT(moment.norm(), 1e-10);
}

TEST(PressureLoad, ActsOnlyBetweenTheHeightsOfTheWindow)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.2;
  shape.edge = 0.01;
  const SurfaceMesh mesh = cylinder_mesh(shape);
  const CylinderCounts counts = cylinder_counts(shape);
  // Polygon of `around` sides, staggered from ring to ring: the radial push of each facet is its
  // area; half the height carries half of it, wherever the window cuts the facets.
  const auto radial = [&](const HeightWindow& window) {
    double sum = 0.0;
    const std::vector<Vec3> force = pushed(mesh, 1.0, window);
    for (std::size_t i = 0; i < force.size(); ++i)
      sum += force[i].dot(Vec3(mesh.node[i].x(), mesh.node[i].y(), 0.0).normalized());
    return sum;
  };
  const double whole = radial({});
  const double side = 2.0 * 0.05 * std::sin(pi / counts.around);
  EXPECT_NEAR(whole, 0.2 * counts.around * side, 0.01 * whole);
  EXPECT_NEAR(radial({0.0, 0.1}) / whole, 0.5, 1e-3);
  EXPECT_NEAR(radial({0.05, 0.1}) / whole, 0.25, 1e-3);
  EXPECT_EQ(radial({0.3, 0.4}), 0.0);
  const double step = 1e-9;  // no jump, although the window's edge lies on a ring of nodes
  EXPECT_NEAR(radial({0.0, 0.1 + step}) - radial({0.0, 0.1}), whole * step / 0.2, 1e-12);
}

TEST(PartInWindow, CutsATriangleByItsSimilarParts)
{
  // Corner at z = 1 over a base at z = 0: above z = h a similar triangle of share (1 - h)^2.
  const FacetPart top = part_in_window({0, 0, 1}, {0.25, 2.0});
  EXPECT_NEAR(top.share, 0.5625, 1e-15);
  // Its centroid is at z = 1 - 2/3 (1 - h) = 0.5.
  EXPECT_NEAR(top.weight.z(), 0.5625 * 0.5, 1e-15);
  const FacetPart band = part_in_window({0, 0, 1}, {0.25, 0.5});
  EXPECT_NEAR(band.share, 0.5625 - 0.25, 1e-15);
  EXPECT_NEAR(band.weight.sum(), band.share, 1e-15);
}

TEST(PartInWindow, PartsOfAdjoiningWindowsMakeTheWholeFacet)
{
  RandomVectors random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 z = random();
    const double cut = 0.5 * random().x();
    const FacetPart low = part_in_window(z, {-2.0, cut}), high = part_in_window(z, {cut, 2.0});
    EXPECT_NEAR(low.share + high.share, 1.0, 1e-14);
    EXPECT_NEAR((low.weight + high.weight - Vec3::Constant(1.0 / 3.0)).norm(), 0.0, 1e-14);
  }
}
