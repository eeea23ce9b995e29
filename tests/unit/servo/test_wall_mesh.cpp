// SPDX-License-Identifier: GPL-2.0-only
#include "servo/wall_mesh.h"

#include "core/constants.h"
#include "core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

using namespace encased_column;

namespace {

const CylinderWall specimen{0.05, -0.01, 0.21, 0.011};

Vec3 area_vector(const SurfaceMesh& mesh, const Facet& t)
{
  const Vec3 a = mesh.node[t[0]];
  return 0.5 * (mesh.node[t[1]] - a).cross(mesh.node[t[2]] - a);
}

double area(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const auto& t : mesh.facet) sum += area_vector(mesh, t).norm();
  return sum;
}

/// How often each edge is walked in each direction.
std::map<std::pair<int, int>, int> walked_edges(const SurfaceMesh& mesh)
{
  std::map<std::pair<int, int>, int> walked;
  for (const auto& t : mesh.facet)
    for (int k = 0; k < 3; ++k) ++walked[{t[k], t[(k + 1) % 3]}];
  return walked;
}

void expect_refusal(const CylinderWall& wall, const std::string& part)
{
  try {
    cylinder_mesh(wall);
    FAIL() << "accepted, expected a sentence with: " << part;
  } catch (const InputError& problem) {
    EXPECT_NE(std::string(problem.what()).find(part), std::string::npos) << problem.what();
  }
}

}  // namespace

TEST(CylinderMesh, HasTheAreaOfThePrismInsideTheCylinder)
{
  const double sides = std::round(2.0 * pi * 0.05 / 0.011);
  EXPECT_NEAR(area(cylinder_mesh(specimen)), sides * 0.05 * 2.0 * std::sin(pi / sides) * 0.22,
              1e-14);
}

TEST(CylinderMesh, HasItsNodesOnTheRadiusAndItsEndsOnBothHeights)
{
  const SurfaceMesh mesh = cylinder_mesh(specimen);
  double low = 1.0, high = -1.0;
  for (const Vec3& node : mesh.node) {
    EXPECT_NEAR(std::hypot(node.x(), node.y()), 0.05, 1e-16);
    low = std::min(low, node.z());
    high = std::max(high, node.z());
  }
  EXPECT_EQ(low, -0.01);
  EXPECT_EQ(high, 0.21);
}

// An oriented surface walks an inner edge once each way; only the two end circles are walked once.
TEST(CylinderMesh, IsWatertightBetweenItsTwoEndCircles)
{
  const SurfaceMesh mesh = cylinder_mesh(specimen);
  const auto walked = walked_edges(mesh);
  int open = 0;
  for (const auto& [edge, times] : walked) {
    EXPECT_EQ(times, 1);
    if (walked.count({edge.second, edge.first})) continue;
    ++open;
    const double z = mesh.node[edge.first].z();
    EXPECT_EQ(z, mesh.node[edge.second].z());
    EXPECT_TRUE(z == -0.01 || z == 0.21);
  }
  EXPECT_EQ(open, 2 * std::lround(2.0 * pi * 0.05 / 0.011));
}

TEST(CylinderMesh, HasEveryNormalAwayFromTheAxis)
{
  const SurfaceMesh mesh = cylinder_mesh(specimen);
  for (const auto& t : mesh.facet) {
    Vec3 center = (mesh.node[t[0]] + mesh.node[t[1]] + mesh.node[t[2]]) / 3.0;
    center.z() = 0.0;
    EXPECT_GT(area_vector(mesh, t).normalized().dot(center.normalized()), 0.99);
  }
}

// Divergence theorem: a third of the flux of x through the lateral surface and the two end
// polygons is the volume of the prism; the ends give n . x = z times the polygon's area.
TEST(CylinderMesh, EnclosesTheVolumeOfThePrism)
{
  const SurfaceMesh mesh = cylinder_mesh(specimen);
  const double sides = std::lround(2.0 * pi * 0.05 / 0.011);
  const double polygon = 0.5 * sides * 0.05 * 0.05 * std::sin(2.0 * pi / sides);
  double flux = polygon * 0.22;
  for (const auto& t : mesh.facet) flux += area_vector(mesh, t).dot(mesh.node[t[0]]);
  EXPECT_NEAR(flux / 3.0, polygon * 0.22, 1e-16);
}

TEST(CylinderMesh, HasEdgesWithinAFifthOfTheWantedLength)
{
  const SurfaceMesh mesh = cylinder_mesh(specimen);
  const auto& t = mesh.facet.front();
  EXPECT_NEAR((mesh.node[t[1]] - mesh.node[t[0]]).norm(), 0.011, 0.0022);
  EXPECT_NEAR((mesh.node[t[2]] - mesh.node[t[1]]).norm(), 0.011, 0.0022);
}

TEST(CylinderMesh, RefusesWhatCannotBeMeshed)
{
  expect_refusal({0.0, 0.0, 0.2, 0.01},
                 "'radius' must be larger than zero, found 0, write a length in m");
  expect_refusal({-0.05, 0.0, 0.2, 0.01},
                 "'radius' must be larger than zero, found -0.05, write a length in m");
  expect_refusal({0.05, 0.2, 0.2, 0.01},
                 "'z_high' must be larger than 'z_low', 0.2, found 0.2, write a larger one");
  expect_refusal({0.05, 0.0, 0.2, 0.0},
                 "'edge' must be larger than zero, found 0, write a length in m");
  expect_refusal({0.05, 0.0, 0.2, 0.06}, "'edge' must not be longer than the radius, 0.05");
  expect_refusal({0.05, 0.0, 0.02, 0.03}, "'edge' must not be longer than the height, 0.02");
  expect_refusal({0.05, 0.0, 0.2, 1e-6}, "at least a thousandth of the radius");
}

TEST(SquareMesh, HasTheAreaOfTheSquareAndNormalsUp)
{
  const SurfaceMesh mesh = square_mesh({0.06, 0.2, 0.02});
  Vec3 sum = Vec3::Zero();
  for (const auto& t : mesh.facet) sum += area_vector(mesh, t);
  EXPECT_NEAR(sum.z(), 0.12 * 0.12, 1e-16);
  EXPECT_NEAR(area(mesh), 0.12 * 0.12, 1e-16);
  for (const Vec3& node : mesh.node) EXPECT_EQ(node.z(), 0.2);
}

TEST(SquareMesh, IsOpenOnlyAlongItsRim)
{
  const SurfaceMesh mesh = square_mesh({0.06, 0.2, 0.02});
  const auto walked = walked_edges(mesh);
  for (const auto& [edge, times] : walked) {
    EXPECT_EQ(times, 1);
    if (walked.count({edge.second, edge.first})) continue;
    const Vec3 middle = 0.5 * (mesh.node[edge.first] + mesh.node[edge.second]);
    EXPECT_NEAR(std::max(std::abs(middle.x()), std::abs(middle.y())), 0.06, 1e-16);
  }
}

TEST(SquareMesh, RefusesWhatCannotBeMeshed)
{
  EXPECT_THROW(square_mesh({0.0, 0.2, 0.02}), InputError);
  EXPECT_THROW(square_mesh({0.06, 0.2, -0.02}), InputError);
  EXPECT_THROW(square_mesh({0.06, 0.2, 0.13}), InputError);
}
