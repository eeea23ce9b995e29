// SPDX-License-Identifier: GPL-2.0-only
#include "shell/level_cut.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// The lateral surface of an upright prism over a polygon that runs anticlockwise, z = 0 to 1.
SurfaceMesh prism(const std::vector<Vec2>& corner)
{
  SurfaceMesh mesh;
  const int n = static_cast<int>(corner.size());
  for (const double z : {0.0, 1.0})
    for (const Vec2& c : corner) mesh.node.emplace_back(c.x(), c.y(), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.facet.push_back({i, j, n + j});
    mesh.facet.push_back({i, n + j, n + i});
  }
  return mesh;
}

std::vector<Vec2> regular_polygon(int n, double radius)
{
  std::vector<Vec2> corner;
  for (int i = 0; i < n; ++i)
    corner.emplace_back(radius * std::cos(2.0 * pi * i / n), radius * std::sin(2.0 * pi * i / n));
  return corner;
}

const std::vector<Vec2> letter_l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

}  // namespace

TEST(LevelCut, AreaOfARegularPrismIsThatOfItsPolygonAtEveryHeight)
{
  for (const int n : {3, 4, 17, 63}) {
    const SurfaceMesh mesh = prism(regular_polygon(n, 0.05));
    const double expected = 0.5 * n * 0.05 * 0.05 * std::sin(2.0 * pi / n);
    for (const double z : {0.001, 0.37, 0.999})
      EXPECT_NEAR(area_at_level(mesh.facet, mesh.node, z) / expected, 1.0, 1e-13);
  }
}

// Half way between two staggered rings the section has a corner in the middle of each lateral edge.
TEST(LevelCut, AreaBetweenStaggeredRingsIsThatOfThePolygonOfTwiceAsManyCorners)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.02;
  shape.edge = 0.02;
  shape.center_x = 0.7;
  const auto [n, rings] = cylinder_counts(shape);
  const SurfaceMesh mesh = cylinder_mesh(shape);
  const double radius = 0.05 * std::cos(pi / (2.0 * n));
  EXPECT_NEAR(area_at_level(mesh.facet, mesh.node, 0.02 * 0.5 / (rings - 1)),
              n * radius * radius * std::sin(pi / n), 1e-15);
}

TEST(LevelCut, AreaOfALetterLIsThatOfItsTwoBars)
{
  const SurfaceMesh mesh = prism(letter_l);
  EXPECT_NEAR(area_at_level(mesh.facet, mesh.node, 0.5), 4.0, 1e-14);
}

TEST(LevelCut, PiecesRunAnticlockwiseAndJoinUp)
{
  const SurfaceMesh mesh = prism(regular_polygon(7, 0.05));
  Vec3 ends = Vec3::Zero();
  int pieces = 0;
  for (const Facet& f : mesh.facet)
    cut_facet(f, mesh.node, 0.4, [&](const Vec3& a, const Vec3& b) {
      EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0);
      EXPECT_DOUBLE_EQ(a.z(), 0.4);
      ends += b - a;
      ++pieces;
    });
  EXPECT_EQ(pieces, 14);
  EXPECT_LT(ends.norm(), 1e-15);
}

TEST(LevelCut, AboveAndBelowTheSurfaceThereIsNothing)
{
  const SurfaceMesh mesh = prism(letter_l);
  for (const double z : {-0.1, 1.1}) {
    EXPECT_EQ(area_at_level(mesh.facet, mesh.node, z), 0.0);
    EXPECT_FALSE(InsideTest(mesh.facet, mesh.node).is_inside(Vec3(0.5, 0.5, z)));
  }
}

TEST(LevelCut, AtTheHeightOfARingTheSectionIsStillWhole)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.1;
  shape.edge = 0.02;
  const SurfaceMesh mesh = cylinder_mesh(shape);
  const int n = cylinder_counts(shape).around;
  const double ring = mesh.node[2 * n].z();
  EXPECT_NEAR(area_at_level(mesh.facet, mesh.node, ring),
              0.5 * n * 0.05 * 0.05 * std::sin(2.0 * pi / n), 1e-15);
  EXPECT_TRUE(InsideTest(mesh.facet, mesh.node).is_inside(Vec3(0.01, 0.02, ring)));
}

TEST(IsInside, AgreesWithTheHalfPlanesOfARegularPolygon)
{
  RandomVectors random(12);
  const int n = 17;
  const SurfaceMesh mesh = prism(regular_polygon(n, 0.05));
  const double inner = 0.05 * std::cos(pi / n);
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 x = Vec3(0.06, 0.06, 0.5).cwiseProduct(random()) + Vec3(0.0, 0.0, 0.5);
    bool expected = true;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * pi * (i + 0.5) / n;
      if (x.x() * std::cos(angle) + x.y() * std::sin(angle) > inner) expected = false;
    }
    EXPECT_EQ(InsideTest(mesh.facet, mesh.node).is_inside(x), expected) << x.transpose();
    if (expected) ++inside;
  }
  EXPECT_GT(inside, 500);
}

TEST(IsInside, AgreesWithTheBarsOfALetterL)
{
  RandomVectors random(13);
  const SurfaceMesh mesh = prism(letter_l);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 x = Vec3(1.0, 1.5, 0.5) + Vec3(1.5, 2.0, 0.49).cwiseProduct(random());
    const bool expected = x.x() > 0.0 && x.y() > 0.0 &&
                          ((x.x() < 2.0 && x.y() < 1.0) || (x.x() < 1.0 && x.y() < 3.0));
    EXPECT_EQ(InsideTest(mesh.facet, mesh.node).is_inside(x), expected) << x.transpose();
  }
}

// A tube that bulges from 50 to 65 mm half way up, in rings 5 mm high.
TEST(IsInside, FollowsABulgeFromRingToRing)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.2;
  shape.edge = 0.005;
  SurfaceMesh mesh = cylinder_mesh(shape);
  const auto radius_at = [](double z) { return 0.05 + 0.015 * std::sin(pi * z / 0.2); };
  for (Vec3& node : mesh.node) node.head<2>() *= radius_at(node.z()) / 0.05;
  const InsideTest test(mesh.facet, mesh.node);
  for (double z = 0.0005; z < 0.2; z += 0.001)
    for (const double angle : {0.1, 1.3, 4.0}) {
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0), level(0.0, 0.0, z);
      for (const double part : {0.3, 0.85, 0.995})
        EXPECT_TRUE(test.is_inside(part * radius_at(z) * out + level)) << "height " << z;
      EXPECT_FALSE(test.is_inside(1.001 * radius_at(z) * out + level)) << "height " << z;
    }
}
