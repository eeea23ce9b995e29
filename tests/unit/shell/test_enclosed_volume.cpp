// SPDX-License-Identifier: GPL-2.0-only
#include "shell/enclosed_volume.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace encased_column;

namespace {

TubeShape small_cylinder()
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.bottom = -0.02;
  shape.height = 0.2;
  shape.edge = 0.01;
  shape.center_x = 0.03;
  return shape;
}

double volume(const SurfaceMesh& mesh, const std::vector<Vec3>& x, const HeightWindow& window = {})
{
  return enclosed_volume(mesh.facet, x, 0, mesh.facet.size(), window);
}

// Adds to `swept` (one per node) the volume [m^3] that each node sweeps along the normals of
// facets [first, last) while all nodes go straight from `from` to `to`:
//
//   share_i = u_i / 3 . integral of the facet's area vector over the way.
//
// The sum over nodes is the volume the surface sweeps, exactly: the area vector is quadratic along
// the way. Where the borders stay or slide in their level planes it is the change of the enclosed
// volume.
void add_swept_volume(const std::vector<Facet>& facet, const std::vector<Vec3>& from,
                      const std::vector<Vec3>& to, int first, int last, std::vector<double>& swept)
{
  for (int f = first; f < last; ++f) {
    const auto [i, j, k] = facet[f];
    const Vec3 side = from[j] - from[i], other = from[k] - from[i];
    const Vec3 side_change = to[j] - to[i] - side, other_change = to[k] - to[i] - other;
    const Vec3 area =
        0.5 * (side.cross(other) + 0.5 * (side.cross(other_change) + side_change.cross(other)) +
               side_change.cross(other_change) / 3.0);
    for (const int node : facet[f]) swept[node] += (to[node] - from[node]).dot(area) / 3.0;
  }
}

double swept(const SurfaceMesh& mesh, const std::vector<Vec3>& from, const std::vector<Vec3>& to)
{
  std::vector<double> node(mesh.node.size(), 0.0);
  add_swept_volume(mesh.facet, from, to, 0, mesh.facet.size(), node);
  return std::accumulate(node.begin(), node.end(), 0.0);
}

}  // namespace

// Between two rings, one turned half a side against the other, the section is that of an antiprism:
// volume h/3 (A + A_mid 4/2 ...) by Simpson over its polygonal sections, exact for a polyhedron.
TEST(EnclosedVolume, OfStaggeredRingsIsThatOfTheAntiprism)
{
  const TubeShape shape = small_cylinder();
  const SurfaceMesh mesh = cylinder_mesh(shape);
  const int n = cylinder_counts(shape).around;
  const double area = 0.5 * n * 0.05 * 0.05 * std::sin(2.0 * pi / n);
  // Half way up the section has 2 n corners, the middles of the lateral edges.
  const double middle_radius = 0.05 * std::cos(pi / (2.0 * n));
  const double middle = n * middle_radius * middle_radius * std::sin(pi / n);
  const double expected = 0.2 * (2.0 * area + 4.0 * middle) / 6.0;
  EXPECT_NEAR(volume(mesh, mesh.node) / expected, 1.0, 1e-12);
}

TEST(EnclosedVolume, OfTwoAdjoiningWindowsIsThatOfBoth)
{
  const SurfaceMesh mesh = cylinder_mesh(small_cylinder());
  const double whole = volume(mesh, mesh.node, {0.0, 0.15});
  EXPECT_NEAR(volume(mesh, mesh.node, {0.0, 0.0731}) + volume(mesh, mesh.node, {0.0731, 0.15}),
              whole, 1e-13 * whole);
}

TEST(EnclosedVolume, ChangeIsTheSumOfTheSweptNodalVolumes)
{
  const SurfaceMesh mesh = cylinder_mesh(small_cylinder());
  const int around = cylinder_counts(small_cylinder()).around;
  const int count = static_cast<int>(mesh.node.size());
  RandomVectors random(2);
  std::vector<Vec3> moved = mesh.node;
  for (int i = 0; i < count; ++i) {
    Vec3 step = 0.004 * random();
    if (i < around || i >= count - around) step.z() = 0.0;  // borders stay in their planes
    moved[i] += step;
  }
  const double change = volume(mesh, moved) - volume(mesh, mesh.node);
  EXPECT_GT(std::abs(change), 1e-7);
  EXPECT_NEAR(swept(mesh, mesh.node, moved), change, 1e-10 * volume(mesh, mesh.node));
}

TEST(EnclosedVolume, SweptInManySmallStepsIsTheSameAsItsChange)
{
  const SurfaceMesh mesh = cylinder_mesh(small_cylinder());
  std::vector<Vec3> from = mesh.node;
  double sum = 0.0;
  for (int step = 0; step < 50; ++step) {
    std::vector<Vec3> to = from;
    for (Vec3& x : to) x += 1e-4 * Vec3(x.x() + std::sin(30.0 * x.z() + step), -x.y(), 0.0);
    sum += swept(mesh, from, to);
    from = to;
  }
  const double whole = volume(mesh, mesh.node);
  EXPECT_NEAR(sum / whole, (volume(mesh, from) - whole) / whole, 1e-10);
}

TEST(EnclosedVolume, IsNegativeWhereTheFacetsLookInward)
{
  TubeShape shape = small_cylinder();
  const double outward = volume(cylinder_mesh(shape), cylinder_mesh(shape).node);
  shape.facing = Facing::inward;
  const SurfaceMesh inward = cylinder_mesh(shape);
  EXPECT_NEAR(volume(inward, inward.node), -outward, 1e-15);
}
