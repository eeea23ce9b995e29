// SPDX-License-Identifier: GPL-2.0-only
#include "shell/height_bands.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/nearest_point.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// A tube that bulges, leans and is dented here and there.
SurfaceMesh crooked_tube()
{
  SurfaceMesh mesh = cylinder_mesh(TubeShape{0.05, 0.0, 0.2, 0.005});
  RandomVectors random(3);
  for (Vec3& node : mesh.node) {
    node.head<2>() *= 1.0 + 0.3 * std::sin(15.0 * node.z());
    node += 0.1 * node.z() * Vec3::UnitX() + 0.001 * random();
  }
  return mesh;
}

double distance_to(const SurfaceMesh& mesh, const Vec3& point)
{
  double nearest = 1e300;
  for (const Facet& f : mesh.facet) {
    const Vec3 &a = mesh.node[f[0]], &b = mesh.node[f[1]], &c = mesh.node[f[2]];
    const Vec3 w = nearest_on_triangle(a, b, c, point);
    nearest = std::min(nearest, (w(0) * a + w(1) * b + w(2) * c - point).norm());
  }
  return nearest;
}

}  // namespace

// By looking at all facets: clear is never wrong, and most points in the middle are.
TEST(HeightBands, SayClearOnlyWhereNoFacetIsNear)
{
  const SurfaceMesh mesh = crooked_tube();
  const HeightBands bands(mesh.facet, mesh.node);
  RandomVectors random(9);
  int clear = 0, far = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 point = Vec3(0.06, 0.06, 0.12).cwiseProduct(random()) + Vec3(0.01, 0.0, 0.1);
    const double reach = 0.004;
    const double distance = distance_to(mesh, point);
    const bool inside_height = point.z() > 0.0 && point.z() < 0.2;
    if (bands.is_clear(point, reach)) {
      ++clear;
      EXPECT_GT(distance, reach) << point.transpose();
    }
    if (inside_height && distance > reach && std::hypot(point.x(), point.y()) < 0.03) ++far;
  }
  EXPECT_GT(clear, far / 2);
  EXPECT_GT(far, 100);
}

// Between two rings of a tube nothing is nearer to its axis than the middle of a chord.
TEST(HeightBands, LeaveTheWholeInsideOfATubeFree)
{
  const TubeShape shape{0.05, 0.0, 0.2, 0.005};
  const SurfaceMesh mesh = cylinder_mesh(shape);
  const HeightBands bands(mesh.facet, mesh.node);
  const double free = 0.05 * std::cos(pi / cylinder_counts(shape).around);
  for (int band = 0; band < bands.size(); ++band)
    for (const double angle : {0.0, 1.0, 2.5, 6.0}) {
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      EXPECT_TRUE(bands.is_in_free_middle(bands.middle(band) + 0.9999 * free * out, band));
      EXPECT_FALSE(bands.is_in_free_middle(bands.middle(band) + 1.0001 * free * out, band));
    }
}

// Flat on the level of the middle, as a lid.
TEST(HeightBands, AreNotFreeUnderAFacetThatCoversTheMiddle)
{
  SurfaceMesh mesh;
  mesh.node = {{-1.0, -1.0, 0.0}, {2.0, -1.0, 0.0}, {-1.0, 2.0, 0.1}};
  mesh.facet = {{0, 1, 2}};
  const HeightBands bands(mesh.facet, mesh.node);
  EXPECT_FALSE(bands.is_in_free_middle(bands.middle(0) + Vec3(1e-6, 0.0, 0.0), 0));
}

TEST(HeightBands, HoldEveryFacetInEachBandItReaches)
{
  const SurfaceMesh mesh = crooked_tube();
  const HeightBands bands(mesh.facet, mesh.node);
  for (int f = 0; f < static_cast<int>(mesh.facet.size()); ++f)
    for (const int node : mesh.facet[f]) {
      const std::vector<int>& there = bands.facets(bands.band_of(mesh.node[node].z()));
      EXPECT_NE(std::find(there.begin(), there.end(), f), there.end());
    }
}

// The sleeve of a run that blew up, in the steps before its check finds it.
TEST(HeightBands, OfPositionsThatAreNoNumbersAreFew)
{
  SurfaceMesh mesh = cylinder_mesh(TubeShape{0.05, 0.0, 0.2, 0.02});
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (Vec3& node : mesh.node) node.z() = nothing;
  const HeightBands bands(mesh.facet, mesh.node);
  EXPECT_LE(bands.size(), 1001);
  bands.is_clear(Vec3(0.0, 0.0, 0.1), 0.01);
  bands.is_clear(Vec3(nothing, 0.0, nothing), 0.01);
}
