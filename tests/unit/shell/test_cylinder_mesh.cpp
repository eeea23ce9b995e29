// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cylinder_mesh.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "shell/pressure_load.h"

#include <gtest/gtest.h>

#include <set>

using namespace encased_column;

namespace {

TubeShape sleeve()
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.2;
  shape.edge = 0.005;
  return shape;
}

std::string refusal(const SurfaceMesh& mesh)
{
  try {
    require_sleeve(mesh);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST(CylinderMesh, OfASpecimenHasTheCountsOfItsEdge)
{
  const CylinderCounts counts = cylinder_counts(sleeve());
  EXPECT_EQ(counts.around, 63);  // 2 pi 50 / 5 = 62.8
  EXPECT_EQ(counts.rings, 47);   // 200 / 4.330 = 46.2 rows
  const SurfaceMesh mesh = cylinder_mesh(sleeve());
  EXPECT_EQ(mesh.node.size(), 63u * 47u);
  EXPECT_EQ(mesh.facet.size(), 2u * 63u * 46u);
}

TEST(CylinderMesh, HasEdgesNearTheWantedLength)
{
  const SurfaceMesh mesh = cylinder_mesh(sleeve());
  for (const Facet& f : mesh.facet)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR((mesh.node[f[i]] - mesh.node[f[(i + 1) % 3]]).norm(), 0.005, 0.05 * 0.005);
}

TEST(CylinderMesh, IsWatertightWithItsTwoEndsAsBorders)
{
  const SurfaceMesh mesh = cylinder_mesh(sleeve());
  const auto loops = border_loops(mesh);
  ASSERT_EQ(loops.size(), 2u);
  std::set<double> heights;
  for (const auto& loop : loops) {
    EXPECT_EQ(loop.size(), 63u);
    for (const int node : loop) heights.insert(mesh.node[node].z());
  }
  EXPECT_EQ(heights, (std::set<double>{0.0, 0.2}));
  EXPECT_EQ(refusal(mesh), "");
  // Euler: a tube has characteristic 0; each inner edge belongs to two facets.
  const long edges = (3 * static_cast<long>(mesh.facet.size()) + 2 * 63) / 2;
  EXPECT_EQ(static_cast<long>(mesh.node.size()) - edges + static_cast<long>(mesh.facet.size()), 0);
}

TEST(CylinderMesh, FacesTheWayItWasAsked)
{
  for (const Facing facing : {Facing::outward, Facing::inward}) {
    TubeShape shape = sleeve();
    shape.facing = facing;
    const SurfaceMesh mesh = cylinder_mesh(shape);
    const double sign = facing == Facing::outward ? 1.0 : -1.0;
    for (const Facet& f : mesh.facet) {
      const Vec3& a = mesh.node[f[0]];
      const Vec3 area = area_vector(a, mesh.node[f[1]], mesh.node[f[2]]);
      EXPECT_GT(sign * area.dot(Vec3(a.x(), a.y(), 0.0)), 0.0);
    }
  }
}

TEST(CylinderMesh, RefusesSizesThatMakeNoMesh)
{
  TubeShape shape = sleeve();
  shape.radius = 0.0;
  EXPECT_THROW(cylinder_mesh(shape), InputError);
  shape = sleeve();
  shape.edge = -0.005;
  EXPECT_THROW(cylinder_mesh(shape), InputError);
  shape.edge = 0.06;
  EXPECT_THROW(cylinder_mesh(shape), InputError);
}

TEST(RequireSleeve, NamesAHole)
{
  SurfaceMesh mesh = cylinder_mesh(sleeve());
  mesh.facet.erase(mesh.facet.begin() + 3000);
  EXPECT_NE(refusal(mesh).find("two borders, its two ends, found 3 (the shortest passes ("),
            std::string::npos);
}

TEST(RequireSleeve, NamesAnInvertedFacet)
{
  SurfaceMesh mesh = cylinder_mesh(sleeve());
  std::swap(mesh.facet[100][0], mesh.facet[100][1]);
  EXPECT_NE(refusal(mesh).find("100"), std::string::npos);
  EXPECT_NE(refusal(mesh).find("turn the inverted facet round"), std::string::npos);
}

TEST(RequireSleeve, RefusesAClosedSurfaceAFacetWithoutAreaAndALooseNode)
{
  SurfaceMesh closed{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  EXPECT_NE(refusal(closed).find("found none"), std::string::npos);
  SurfaceMesh mesh = cylinder_mesh(sleeve());
  mesh.facet.push_back({0, 1, 1});
  EXPECT_NE(refusal(mesh).find("needs an area"), std::string::npos);
  mesh = cylinder_mesh(sleeve());
  mesh.node.emplace_back(0.0, 0.0, 0.1);
  EXPECT_NE(refusal(mesh).find("node 2961"), std::string::npos);
}

TEST(Welded, TrianglesOneByOneMakeTheMeshTheyCameFrom)
{
  const SurfaceMesh mesh = cylinder_mesh(sleeve());
  std::vector<std::array<Vec3, 3>> soup;
  for (std::size_t f = 0; f < mesh.facet.size(); ++f) {
    std::array<Vec3, 3> corner;
    for (int i = 0; i < 3; ++i)
      corner[i] = mesh.node[mesh.facet[f][i]] + 1e-9 * Vec3(std::sin(f), std::cos(f + i), 0.0);
    soup.push_back(corner);
  }
  const SurfaceMesh found = welded(soup, 1e-7);
  EXPECT_EQ(found.node.size(), mesh.node.size());
  EXPECT_EQ(border_loops(found).size(), 2u);
}

// A million facets; one more length of the edge would narrow the counts of an int.
TEST(CylinderMesh, RefusesMoreFacetsThanAMachineHolds)
{
  for (const double edge : {1e-6, 1e-12, 1e-300}) {
    std::string found = "not refused";
    try {
      cylinder_mesh(TubeShape{0.05, 0.0, 0.2, edge});
    } catch (const InputError& problem) {
      found = problem.what();
    }
    EXPECT_EQ(found.find("edge of the sleeve must leave 1000000 facets at most, found"), 0u)
        << found;
  }
}

TEST(RequireSleeve, NamesADoubleFacetAndABranchAsWhatTheyAre)
{
  SurfaceMesh mesh = cylinder_mesh(sleeve());
  const Facet first = mesh.facet[0];
  mesh.facet.push_back({first[1], first[0], first[2]});
  EXPECT_NE(refusal(mesh).find("every facet of the mesh must stand once, found facet 5796 at "),
            std::string::npos)
      << refusal(mesh);
  mesh = cylinder_mesh(sleeve());
  mesh.node.emplace_back(0.2, 0.0, 0.1);
  mesh.facet.push_back({first[2], first[1], static_cast<int>(mesh.node.size()) - 1});
  EXPECT_NE(refusal(mesh).find("an edge of the mesh must join two facets at most"),
            std::string::npos)
      << refusal(mesh);
}
