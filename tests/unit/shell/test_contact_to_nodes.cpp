// SPDX-License-Identifier: GPL-2.0-only
#include "shell/contact_to_nodes.h"

#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

void expect_equivalent(const FacetVectors& corner, const Vec3& point, const Vec3& force,
                       const Vec3& moment)
{
  const FacetVectors nodal = FacetLever(corner, point).nodal_forces(force, moment);
  Vec3 force_sum = Vec3::Zero(), moment_sum = Vec3::Zero();
  double largest_force = force.norm(), largest_moment = moment.norm() + force.norm();
  for (int i = 0; i < 3; ++i) {
    force_sum += nodal[i];
    moment_sum += (corner[i] - point).cross(nodal[i]);
    largest_force = std::max(largest_force, nodal[i].norm());
    largest_moment = std::max(largest_moment, (corner[i] - point).cross(nodal[i]).norm());
  }
  EXPECT_LE((force_sum - force).norm(), 1e-12 * largest_force);
  EXPECT_LE((moment_sum - moment).norm(), 1e-12 * largest_moment);
}

}  // namespace

TEST(ContactToNodes, KeepsForceAndMomentAnywhereOnOrOverTheFacet)
{
  RandomVectors random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const FacetVectors corner{random(), random(), random()};
    if ((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() < 0.1) continue;
    expect_equivalent(corner, random(), random(), random());
  }
}

TEST(ContactToNodes, KeepsThemOnAFiveMillimetreFacetOfALargeSleeve)
{
  const FacetVectors corner{Vec3(0.05, 0.0, 0.1), Vec3(0.0498, 0.005, 0.1),
                            Vec3(0.0499, 0.0025, 0.1043)};
  expect_equivalent(corner, Vec3(0.04985, 0.0026, 0.1012), Vec3(300.0, -5.0, 80.0),
                    Vec3(0.0, 0.3, -0.1));
}

TEST(ContactToNodes, GivesAForceInTheFacetByItsAreaCoordinates)
{
  const FacetVectors corner = skew_triangle();
  const Vec3 share(0.2, 0.5, 0.3), force(1.0, -2.0, 3.0);
  const Vec3 point = share(0) * corner[0] + share(1) * corner[1] + share(2) * corner[2];
  const FacetVectors nodal = FacetLever(corner, point).nodal_forces(force, Vec3::Zero());
  for (int i = 0; i < 3; ++i) EXPECT_NEAR((nodal[i] - share(i) * force).norm(), 0.0, 1e-14);
}

TEST(ContactToNodes, GivesAForceAtANodeToThatNode)
{
  const FacetVectors corner = skew_triangle();
  const FacetVectors nodal =
      FacetLever(corner, corner[2]).nodal_forces(Vec3::UnitX(), Vec3::Zero());
  EXPECT_NEAR(nodal[0].norm() + nodal[1].norm(), 0.0, 1e-14);
  EXPECT_NEAR((nodal[2] - Vec3::UnitX()).norm(), 0.0, 1e-14);
}
