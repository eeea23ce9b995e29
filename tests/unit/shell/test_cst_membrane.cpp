// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_element.h"

#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

// MacNeal and Harder's patch, Finite Elem. Anal. Des. 1 (1985) 3-20: 0.24 x 0.12, four inner nodes.
const std::vector<Vec3> patch_node{{0.0, 0.0, 0.0},   {0.24, 0.0, 0.0},  {0.24, 0.12, 0.0},
                                   {0.0, 0.12, 0.0},  {0.04, 0.02, 0.0}, {0.18, 0.03, 0.0},
                                   {0.16, 0.08, 0.0}, {0.08, 0.08, 0.0}};
const std::vector<std::array<int, 3>> patch_facet{{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5},
                                                  {2, 3, 6}, {3, 7, 6}, {3, 0, 7}, {0, 4, 7},
                                                  {4, 5, 6}, {4, 6, 7}};

ShellMaterial patch_material()
{
  ShellConstants c;
  c.modulus_hoop = 1e6;
  c.poisson = 0.25;
  c.thickness = 0.001;
  c.density = 1.0;
  return ShellMaterial(c);
}

const FacetRotations no_turn{Mat3::Identity(), Mat3::Identity(), Mat3::Identity()};

}  // namespace

TEST(CstMembrane, PatchOfMacNealAndHarderHasTheStressOfTheAffineField)
{
  const ShellMaterial material = patch_material();
  double area = 0.0, energy = 0.0;
  std::vector<Vec3> force(patch_node.size(), Vec3::Zero());
  for (const auto& facet : patch_facet) {
    FacetVectors from, to;
    for (int i = 0; i < 3; ++i) {
      const Vec3& x = patch_node[facet[i]];
      from[i] = x;
      to[i] = x + 1e-3 * Vec3(x.x() + x.y() / 2.0, x.y() + x.x() / 2.0, 0.0);
    }
    const ShellElement element(from, Vec3::UnitY(), material);
    const FacetState state = element.state(material, to, no_turn);
    const double t = material.constants().thickness;
    EXPECT_NEAR(state.membrane_force(0) / t / (4000.0 / 3.0), 1.0, 1e-10);
    EXPECT_NEAR(state.membrane_force(1) / t / (4000.0 / 3.0), 1.0, 1e-10);
    EXPECT_NEAR(state.membrane_force(2) / t / 400.0, 1.0, 1e-10);
    const FacetLoads loads = element.loads(material, to, no_turn);
    for (int i = 0; i < 3; ++i) force[facet[i]] += loads.force[i];
    area += element.area();
    energy += loads.energy;
  }
  EXPECT_NEAR(area, 0.24 * 0.12, 1e-15);
  const double density = 0.5 * (2.0 * 1e-3 * 4000.0 / 3.0 + 1e-3 * 400.0);
  EXPECT_NEAR(energy / (0.001 * area * density), 1.0, 1e-10);
  for (int i = 4; i < 8; ++i)
    EXPECT_NEAR(force[i].norm(), 0.0, 1e-10 * force[0].norm()) << "inner node " << i;
}

// A square bar pulled to the stretch 1.4 and free to contract: engineering strain, E t times it.
TEST(CstMembrane, AtLargeStrainIsTheStripTestInEngineeringStrain)
{
  const ShellMaterial material(isotropic_shell());
  const FacetVectors from{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};
  const ShellElement element(from, Vec3::UnitZ(), material);
  FacetVectors to;
  for (int i = 0; i < 3; ++i) to[i] = Vec3(1.4 * from[i].x(), 0.0, (1.0 - 0.3 * 0.4) * from[i].z());
  const FacetState state = element.state(material, to, no_turn);
  EXPECT_NEAR(state.strain(0), 0.4, 1e-14);
  EXPECT_NEAR(state.membrane_force(0), 1e6 * 0.1 * 0.4, 1e-8);
  EXPECT_NEAR(state.membrane_force(1), 0.0, 1e-8);
  EXPECT_NEAR(element.loads(material, to, no_turn).force[1].x(), -1e5 * 0.4 * 0.5, 1e-8);
}

TEST(CstMembrane, OrthotropicAxesFollowTheAxialDirectionOfTheFacet)
{
  const ShellMaterial material(orthotropic_shell());
  const Vec3 axis = Vec3(1.0, 1.0, 0.0).normalized(), across = Vec3(1.0, -1.0, 0.0).normalized();
  const FacetVectors from{Vec3(0, 0, 0), Vec3(1, 0.2, 0), Vec3(0.1, 0.9, 0)};
  const ShellElement element(from, axis, material);
  EXPECT_NEAR(std::abs(element.hoop_direction().dot(across)), 1.0, 1e-15);
  FacetVectors to;
  for (int i = 0; i < 3; ++i)
    to[i] = from[i] + 0.01 * across.dot(from[i]) * across + 0.002 * axis.dot(from[i]) * axis;
  const FacetState state = element.state(material, to, no_turn);
  // E_h = 1e6, E_a = 2.5e5, nu = 0.3: 1 - nu^2 E_a / E_h = 0.9775.
  EXPECT_NEAR(state.membrane_force(0), 0.1 * (1e6 * 0.01 + 0.3 * 2.5e5 * 0.002) / 0.9775, 1e-8);
  EXPECT_NEAR(state.membrane_force(1), 0.1 * (0.3 * 2.5e5 * 0.01 + 2.5e5 * 0.002) / 0.9775, 1e-8);
  EXPECT_NEAR(state.membrane_force(2), 0.0, 1e-9);
}
