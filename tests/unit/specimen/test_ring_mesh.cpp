// SPDX-License-Identifier: GPL-2.0-only
#include "specimen/ring_mesh.h"

#include "core/constants.h"

#include <gtest/gtest.h>

#include <map>

using namespace encased_column;

namespace {

const Rings rings{0.05, -0.02, 0.21, 12, 7, false, 0.3, -0.1};

Rings staggered()
{
  Rings turned = rings;
  turned.staggered = true;
  return turned;
}

Vec3 double_area(const SurfaceMesh& mesh, const Facet& f)
{
  const Vec3& a = mesh.node[f[0]];
  return (mesh.node[f[1]] - a).cross(mesh.node[f[2]] - a);
}

}  // namespace

// An oriented surface walks each inner edge once each way: only the two end polygons are open.
TEST(RingMesh, IsWatertightBetweenItsTwoEnds)
{
  for (const Rings& shape : {rings, staggered()}) {
    std::map<std::pair<int, int>, int> walked;
    const SurfaceMesh mesh = mesh_of(shape);
    EXPECT_EQ(mesh.node.size(), 12u * 8u);
    EXPECT_EQ(mesh.facet.size(), 2u * 12u * 7u);
    for (const Facet& f : mesh.facet)
      for (int k = 0; k < 3; ++k) ++walked[{f[k], f[(k + 1) % 3]}];
    int open = 0;
    for (const auto& [edge, times] : walked) {
      EXPECT_EQ(times, 1);
      open += walked.count({edge.second, edge.first}) == 0;
    }
    EXPECT_EQ(open, 2 * 12);
  }
}

// Gauss with the field (x, y, 0) / 2: rectangles enclose the prism over the regular polygon.
TEST(RingMesh, OfRectanglesEnclosesThePrismOverItsPolygon)
{
  const SurfaceMesh mesh = mesh_of(rings);
  double volume = 0.0;
  for (const Facet& f : mesh.facet) {
    const Vec3 center = (mesh.node[f[0]] + mesh.node[f[1]] + mesh.node[f[2]]) / 3.0;
    const Vec3 half = double_area(mesh, f) / 2.0;
    volume += 0.5 * (half.x() * center.x() + half.y() * center.y());
  }
  EXPECT_NEAR(volume, 0.5 * 12 * 0.05 * 0.05 * std::sin(2.0 * pi / 12) * 0.21, 1e-15);
}

TEST(RingMesh, StaggeredHasEquilateralFacetsWhereRowsAreAsHighAsTheyMust)
{
  Rings shape = staggered();
  shape.around = 600;
  const double edge = 2.0 * shape.radius * std::sin(pi / shape.around);
  shape.height = shape.rows * edge * std::sqrt(0.75);
  const SurfaceMesh mesh = mesh_of(shape);
  for (const Facet& f : mesh.facet)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR((mesh.node[f[k]] - mesh.node[f[(k + 1) % 3]]).norm(), edge, 1e-5 * edge);
}

TEST(RingMesh, StandsOnItsAxisAndLooksAwayFromIt)
{
  const Vec3 axis(0.3, -0.1, 0.0);
  for (const Rings& shape : {rings, staggered()}) {
    const SurfaceMesh mesh = mesh_of(shape);
    for (std::size_t n = 0; n < mesh.node.size(); ++n) {
      const Vec3 out = mesh.node[n] - axis;
      EXPECT_NEAR(std::hypot(out.x(), out.y()), 0.05, 1e-15);
      EXPECT_NEAR(out.z(), -0.02 + 0.03 * static_cast<double>(n / 12), 1e-15);
    }
    for (const Facet& f : mesh.facet)
      EXPECT_GT(double_area(mesh, f).dot(mesh.node[f[0]] - axis), 0.0);
  }
}
