// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_element.h"

#include "core/eigenvalues.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

struct LawCase {
  const char* name;
  ShellConstants (*constants)();
};

void PrintTo(const LawCase& law, std::ostream* out)
{
  *out << law.name;
}

class ShellElementLaw : public testing::TestWithParam<LawCase> {};

INSTANTIATE_TEST_SUITE_P(Laws, ShellElementLaw,
                         testing::Values(LawCase{"isotropic", isotropic_shell},
                                         LawCase{"orthotropic", orthotropic_shell},
                                         LawCase{"tension_only", wrinkling_shell},
                                         LawCase{"tension_only_orthotropic",
                                                 wrinkling_orthotropic_shell}),
                         [](const auto& info) { return info.param.name; });

double largest(const FacetVectors& v)
{
  return std::max({v[0].norm(), v[1].norm(), v[2].norm()});
}

}  // namespace

TEST_P(ShellElementLaw, ForcesAndMomentsAreMinusTheGradientOfTheEnergy)
{
  const ShellMaterial material(GetParam().constants());
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  for (const auto& [strain, bend] : {std::pair{0.003, 0.01}, {0.05, 0.2}, {0.3, 0.9}}) {
    const DeformedFacet facet = deformed(skew_triangle(), strain, bend, Vec3(2.0, 1.0, -0.5), 7);
    const FacetLoads loads = element.loads(material, facet.x, facet.matrices());
    const double h = 1e-4 * strain;
    for (int node = 0; node < 3; ++node)
      for (int axis = 0; axis < 3; ++axis) {
        // Fourth-order differences, so that round-off and truncation stay below the tolerance.
        double push = 0.0, turn = 0.0;
        for (const auto& [k, weight] : {std::pair{1, 8.0}, {2, -1.0}, {-1, -8.0}, {-2, 1.0}}) {
          DeformedFacet moved = facet, turned = facet;
          const Vec3 step = k * h * Vec3::Unit(axis);
          moved.x[node] += step;
          turned.q[node] = rotation_from_vector(step) * facet.q[node];
          push += weight * element.loads(material, moved.x, moved.matrices()).energy;
          turn += weight * element.loads(material, turned.x, turned.matrices()).energy;
        }
        EXPECT_NEAR(-push / (12.0 * h), loads.force[node](axis), 1e-6 * largest(loads.force));
        EXPECT_NEAR(-turn / (12.0 * h), loads.moment[node](axis), 1e-6 * largest(loads.moment));
      }
  }
}

TEST_P(ShellElementLaw, RigidMotionOfAnySizeGivesNoLoad)
{
  const ShellMaterial material(GetParam().constants());
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  const double scale = material.membrane()(0, 0);
  for (const double angle : {1e-6, 0.3, 1.5, 3.0}) {
    DeformedFacet facet = deformed(skew_triangle(), 0.0, 0.0, angle * Vec3(0.6, -0.48, 0.64), 1);
    for (Vec3& x : facet.x) x += Vec3(3.0, -5.0, 2.0);
    const FacetLoads loads = element.loads(material, facet.x, facet.matrices());
    EXPECT_LT(largest(loads.force), 1e-13 * scale);
    EXPECT_LT(largest(loads.moment), 1e-13 * scale);
    EXPECT_LT(loads.energy, 1e-24 * scale);
  }
}

TEST_P(ShellElementLaw, LoadsTurnWithTheWholeAndAreInBalance)
{
  const ShellMaterial material(GetParam().constants());
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  const Vec3 turn(-1.0, 2.0, 0.7);
  const DeformedFacet here = deformed(skew_triangle(), 0.2, 0.6, Vec3::Zero(), 3);
  const DeformedFacet there = deformed(skew_triangle(), 0.2, 0.6, turn, 3);
  const FacetLoads a = element.loads(material, here.x, here.matrices());
  const FacetLoads b = element.loads(material, there.x, there.matrices());
  EXPECT_NEAR(b.energy / a.energy, 1.0, 1e-12);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT((b.force[i] - rotation_from_vector(turn) * a.force[i]).norm(),
              1e-12 * largest(a.force));
    EXPECT_LT((b.moment[i] - rotation_from_vector(turn) * a.moment[i]).norm(),
              1e-12 * largest(a.moment));
    force += b.force[i];
    moment += b.moment[i] + there.x[i].cross(b.force[i]);
  }
  EXPECT_LT(force.norm(), 1e-14 * largest(b.force));
  EXPECT_LT(moment.norm(), 1e-13 * largest(b.force));
}

TEST_P(ShellElementLaw, EnergyDoesNotDependOnTheOrderOfTheNodes)
{
  const ShellMaterial material(GetParam().constants());
  const FacetVectors reference = skew_triangle();
  const DeformedFacet facet = deformed(reference, 0.2, 0.6, Vec3(0.3, 2.0, 1.0), 11);
  const double energy = ShellElement(reference, Vec3::UnitZ(), material)
                            .loads(material, facet.x, facet.matrices())
                            .energy;
  for (const Eigen::Vector3i& order : {Eigen::Vector3i(1, 2, 0), Eigen::Vector3i(2, 0, 1),
                                       Eigen::Vector3i(0, 2, 1), Eigen::Vector3i(2, 1, 0)}) {
    FacetVectors corner;
    DeformedFacet swapped;
    for (int i = 0; i < 3; ++i) {
      corner[i] = reference[order(i)];
      swapped.x[i] = facet.x[order(i)];
      swapped.q[i] = facet.q[order(i)];
    }
    const ShellElement element(corner, Vec3::UnitZ(), material);
    EXPECT_NEAR(element.loads(material, swapped.x, swapped.matrices()).energy / energy, 1.0, 1e-12);
  }
}

// Tilts of w = k |r|^2 / 2 about the first corner. The heights w are left out: they turn the plane
// of the nodes and bend nothing by themselves, so the mean curvature follows from the tilts'
// divergence.
TEST(ShellElement, BentToASphereHasTheMomentOfItsCurvature)
{
  const ShellMaterial material(isotropic_shell());
  const FacetVectors corner = skew_triangle();
  const ShellElement element(corner, Vec3::UnitZ(), material);
  const double k = 1e-4;
  DeformedFacet facet;
  for (int i = 0; i < 3; ++i) {
    const Vec3 arm = corner[i] - corner[0];
    facet.x[i] = corner[i] + 0.5 * k * arm.squaredNorm() * element.normal();
    facet.q[i] = rotation_from_vector(k * arm.cross(element.normal()));
  }
  const FacetState state = element.state(material, facet.x, facet.matrices());
  const double d = material.bending()(0, 0);
  EXPECT_NEAR((state.curvature - PlaneVector(k, k, 0.0)).norm(), 0.0, 1e-6 * k);
  EXPECT_NEAR((state.moment - 1.3 * d * PlaneVector(k, k, 0.0)).norm(), 0.0, 1e-6 * d * k);
  EXPECT_NEAR(state.bending_energy / (element.area() * 1.3 * d * k * k), 1.0, 1e-6);
}

TEST(ShellElement, StateAndLoadsHaveTheSameEnergy)
{
  const ShellMaterial material(orthotropic_shell());
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  const DeformedFacet facet = deformed(skew_triangle(), 0.1, 0.4, Vec3(1.0, 0.0, 0.0), 2);
  const FacetState state = element.state(material, facet.x, facet.matrices());
  EXPECT_NEAR((state.membrane_energy + state.bending_energy) /
                  element.loads(material, facet.x, facet.matrices()).energy,
              1.0, 1e-13);
}

TEST(ShellElement, DrillingOfANodeIsFree)
{
  const ShellMaterial material(isotropic_shell());
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  const DeformedFacet facet = deformed(skew_triangle(), 0.1, 0.4, Vec3(1.0, 0.0, 0.0), 2);
  DeformedFacet drilled = facet;
  drilled.q[1] = facet.q[1] * rotation_from_vector(1.3 * element.normal());
  const FacetLoads before = element.loads(material, facet.x, facet.matrices());
  const FacetLoads after = element.loads(material, drilled.x, drilled.matrices());
  EXPECT_NEAR(after.energy / before.energy, 1.0, 1e-13);
  const Vec3 director = facet.q[1] * element.normal();
  EXPECT_NEAR(before.moment[1].dot(director), 0.0, 1e-13 * before.moment[1].norm());
}

TEST(ShellElement, WithoutBendingThicknessPutsNoMomentOnItsNodes)
{
  ShellConstants c = isotropic_shell();
  c.bending_thickness = 0.0;
  const ShellMaterial material(c);
  const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
  const DeformedFacet facet = deformed(skew_triangle(), 0.1, 0.4, Vec3(1.0, 0.0, 0.0), 2);
  EXPECT_EQ(largest(element.loads(material, facet.x, facet.matrices()).moment), 0.0);
}

// The bound must exceed every eigenvalue of the true tangent stiffness, taken here by differences
// of the loads, once translations and rotations are divided by their bounds.
TEST_P(ShellElementLaw, StiffnessBoundHoldsForTheTangentAndIsNotWasteful)
{
  for (const double thickness : {0.01, 0.1, 0.5}) {
    ShellConstants c = GetParam().constants();
    c.thickness = thickness;
    const ShellMaterial material(c);
    const ShellElement element(skew_triangle(), Vec3::UnitZ(), material);
    for (const double strain : {0.0, 0.03}) {
      const DeformedFacet facet = deformed(skew_triangle(), strain, 0.0, Vec3(0.5, 1.0, 0.0), 4);
      const StiffnessBound bound = element.stiffness_bound(material, facet.x);
      const double h = 1e-6;
      Eigen::MatrixXd tangent(18, 18);
      for (int j = 0; j < 18; ++j) {
        const double scale = std::sqrt(j < 9 ? bound.translation : bound.rotation);
        const auto moved = [&](double step) {
          DeformedFacet out = facet;
          const Vec3 way = step * Vec3::Unit(j % 3);
          if (j < 9)
            out.x[j / 3] += way;
          else
            out.q[j / 3 - 3] = rotation_from_vector(way) * facet.q[j / 3 - 3];
          return element.loads(material, out.x, out.matrices());
        };
        const FacetLoads up = moved(h), down = moved(-h);
        for (int i = 0; i < 3; ++i) {
          tangent.block<3, 1>(3 * i, j) =
              -(up.force[i] - down.force[i]) / (2.0 * h) / (scale * std::sqrt(bound.translation));
          tangent.block<3, 1>(9 + 3 * i, j) =
              -(up.moment[i] - down.moment[i]) / (2.0 * h) / (scale * std::sqrt(bound.rotation));
        }
      }
      const double found = symmetric_eigenvalues(0.5 * (tangent + tangent.transpose())).maxCoeff();
      EXPECT_LE(found, 1.001) << "t " << thickness << " strain " << strain;
      if (strain == 0.0 && !c.tension_only) {
        EXPECT_GT(found, 0.5) << "t " << thickness;
      }
    }
  }
}

TEST(ShellElement, RefusesAFacetWithoutArea)
{
  const ShellMaterial material(isotropic_shell());
  const FacetVectors line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  EXPECT_THROW(ShellElement(line, Vec3::UnitZ(), material), InputError);
}
