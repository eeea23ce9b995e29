// SPDX-License-Identifier: GPL-2.0-only
// Closed forms of columns in a sleeve: the sleeve as a mesh, the soil as a line of failure.
#include "analysis/encasement.h"
#include "analysis/strength.h"
#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/sleeve_state.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace encased_column;

namespace {

constexpr double column_stiffness = 115e3, column_radius = 0.05;  // J [N/m], R0 [m]
constexpr double column_friction = 36.4 * pi / 180.0;             // phi [rad]

ShellConstants cloth_of_column()
{
  ShellConstants c;
  c.modulus_hoop = column_stiffness / 0.002;
  c.poisson = 0.3;
  c.thickness = 0.002;
  c.bending_thickness = 0.0;
  c.density = 500.0;
  c.tension_only = true;
  c.cloth.strength = {9200.0, 9200.0};
  return c;
}

ShellModel sleeve_of_column(const ShellConstants& c, double edge = 0.02)
{
  return ShellModel(cylinder_mesh(TubeShape{column_radius, 0.0, 0.04, edge}), c, Vec3::UnitZ());
}

/// The sleeve on a column shortened by `axial` that has grown by `volumetric` of its volume; loads
/// until nothing yields any more. Returns its hoop strain.
double put_on_column(ShellModel& model, double axial, double volumetric)
{
  const double stretch = std::sqrt((1.0 + volumetric) / (1.0 - axial));
  std::vector<Vec3> x = model.reference();
  for (Vec3& p : x) p = Vec3(stretch * p.x(), stretch * p.y(), (1.0 - axial) * p.z());
  model.set_state(x, model.rotation(), model.velocity(), model.angular_velocity());
  for (int n = 0; n < 30; ++n) {
    model.clear_loads();
    model.add_internal_loads(0, model.facets());
  }
  return stretch - 1.0;
}

/// q [Pa] of the column in its sleeve as it stands.
double strength_of_column(const ShellModel& model, double hoop_strain, double confining_stress)
{
  const double ring = confinement_of_ring(summary_of(model, HeightWindow()).hoop_tension,
                                          stretched_radius(column_radius, hoop_strain));
  return encased_deviatoric_stress(passive_coefficient(std::sin(column_friction)), confining_stress,
                                   ring);
}

}  // namespace

// The whole strip in one state of strain, whatever its facets: N on its ends, nothing inside.
TEST(StripOfAnyMesh, BearsItsTableAndHoldsNoForceInside)
{
  const double length = 0.1, width = 0.04;
  const int along = 5, across = 4;
  RandomVectors random(7);
  SurfaceMesh mesh;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      const bool inside = i > 0 && i < along && j > 0 && j < across;
      const Vec3 off = inside ? Vec3(0.006 * random()) : Vec3::Zero();
      mesh.node.push_back({i * length / along + off.x(), 0.0, j * width / across + off.z()});
    }
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const int a = i * (across + 1) + j, b = a + across + 1;
      if ((i + j) % 2 == 0) {
        mesh.facet.push_back({a, b, a + 1});
        mesh.facet.push_back({b, b + 1, a + 1});
      } else {
        mesh.facet.push_back({a, b, b + 1});
        mesh.facet.push_back({a, b + 1, a + 1});
      }
    }
  for (const bool tension_only : {false, true}) {
    ShellConstants c = cloth_of_column();
    c.tension_only = tension_only;
    c.cloth = {};
    for (auto& table : c.cloth.strip) table = {{0.0, 0.0}, {0.06, 6900.0}, {0.08, 7900.0}};
    ShellModel strip(mesh, c, Vec3::UnitZ());
    for (const auto& [strain, tension] :
         {std::pair{0.02, 2300.0}, {0.04, 4600.0}, {0.06, 6900.0}, {0.08, 7900.0}}) {
      std::vector<Vec3> x = strip.reference();
      for (Vec3& p : x) {
        p.x() *= 1.0 + strain;
        p.z() *= 1.0 - 0.3 * tension / column_stiffness;  // contraction is elastic
      }
      strip.set_state(x, strip.rotation(), strip.velocity(), strip.angular_velocity());
      double stored = 0.0;
      for (int n = 0; n < 60; ++n) {
        strip.clear_loads();
        stored = strip.add_internal_loads(0, strip.facets());
      }
      double end = 0.0;
      for (int i = 0; i < strip.nodes(); ++i) {
        const double at = strip.reference()[i].x();
        if (at > 0.999 * length) end -= strip.force(i).x();
        if (at > 0.001 * length && at < 0.999 * length) {
          EXPECT_LT(strip.force(i).norm(), 1e-10 * tension * width) << i;
        }
      }
      EXPECT_NEAR(end / width, tension, 1e-10 * 9200.0) << strain;
      EXPECT_NEAR(stored / (length * width), 0.5 * tension * tension / column_stiffness, 1e-8);
    }
  }
}

// eps_a = (a^2 - 1) / (D + a^2), a = 1 + eps_u, D = 2 sin psi / (1 - sin psi): a column that
// dilates by D times its shortening, in a cloth that parts at eps_u = N_u / J.
TEST(EncasedColumn, RupturesAtTheAxialStrainOfItsDilatancy)
{
  ShellConstants c = cloth_of_column();
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 1000.0;
  const double stretch = 1.0 + c.cloth.strength[0] / column_stiffness;
  for (const auto& [degrees, tabulated] :
       {std::pair{0.0, 0.1427}, {5.0, 0.1226}, {10.0, 0.1049}, {15.0, 0.0892}}) {
    const double sine = std::sin(degrees * pi / 180.0);
    const double dilation = 2.0 * sine / (1.0 - sine);
    double whole = 0.0, parted = 0.3;
    while (parted - whole > 1e-12) {
      const double axial = 0.5 * (whole + parted);
      ShellModel sleeve = sleeve_of_column(c);
      put_on_column(sleeve, axial, dilation * axial);
      (summary_of(sleeve, HeightWindow()).damage_max > 0.0 ? parted : whole) = axial;
    }
    EXPECT_NEAR(whole, tabulated, 5e-5) << degrees;
    EXPECT_NEAR(whole, (stretch * stretch - 1.0) / (dilation + stretch * stretch), 1e-10);

    ShellModel sleeve = sleeve_of_column(c);
    const double hoop_strain = put_on_column(sleeve, whole, dilation * whole);
    for (const auto& [confining_stress, q] :
         {std::pair{50e3, 813.6e3}, {100e3, 959.6e3}, {150e3, 1105.6e3}})
      EXPECT_NEAR(strength_of_column(sleeve, hoop_strain, confining_stress), q, 0.15e3) << degrees;
  }
}

// q = Kp (sigma3 + N_y / r) - sigma3 at any strain behind the yield: steps of (Kp - 1) 50 kPa, the
// friction angle of the soil, and the apparent cohesion c = (dsigma3 / 2) sqrt(Kp).
TEST(EncasedColumn, HasAPlateauOfItsSoilsFrictionAndOfTheClothsCohesion)
{
  ShellConstants c = cloth_of_column();
  c.cloth.strength = {6500.0, 6500.0};
  c.cloth.after = AfterStrength::yield;
  ShellModel sleeve = sleeve_of_column(c);
  const double root = std::tan(pi / 4.0 + column_friction / 2.0);  // of Kp
  for (const double axial : {0.12, 0.16, 0.20}) {
    const double hoop_strain = put_on_column(sleeve, axial, 0.0);
    const double ring = 6500.0 / (column_radius * (1.0 + hoop_strain));
    std::vector<StressPoint> peaks;
    double before = 0.0;
    for (const double confining_stress : {50e3, 100e3, 150e3}) {
      const double q = strength_of_column(sleeve, hoop_strain, confining_stress);
      EXPECT_NEAR(q, root * root * (confining_stress + ring) - confining_stress, 1e-8 * q);
      if (!peaks.empty()) {
        EXPECT_NEAR(q - before, 146.0e3, 0.1e3);
      }
      before = q;
      peaks.push_back(stress_point(confining_stress, q));
    }
    const Strength strength = strength_of(fit_failure_line(peaks));
    EXPECT_NEAR(strength.friction_angle, column_friction, 1e-8);
    EXPECT_NEAR(strength.cohesion, 0.5 * ring * root, 1e-6 * ring);
  }
}

// dsigma3 = (2 J / D0) (1 - sqrt(1 - eps_a)) = N / r at constant volume, N per length of the sleeve
// without load. Bathurst and Karpurapu (1993) print it over (1 - eps_a): N per present length, as
// the nodes of a sleeve that shortens with its column press.
TEST(EncasedColumn, OfConstantVolumeHasTheExactConfinementAndCohesion)
{
  const double axial = 0.10;
  ShellModel sleeve = sleeve_of_column(cloth_of_column(), 0.005);
  const double hoop_strain = put_on_column(sleeve, axial, 0.0);
  const double exact = column_stiffness / column_radius * (1.0 - std::sqrt(1.0 - axial));
  const double ring = confinement_of_ring(summary_of(sleeve, HeightWindow()).hoop_tension,
                                          stretched_radius(column_radius, hoop_strain));
  EXPECT_NEAR(exact, 118.0e3, 0.05e3);
  EXPECT_NEAR(ring, exact, 1e-10 * exact);

  double inward = 0.0, low = 1.0, high = 0.0;
  for (int i = 0; i < sleeve.nodes(); ++i) {
    const Vec3& x = sleeve.position()[i];
    inward -= sleeve.force(i).dot(Vec3(x.x(), x.y(), 0.0).normalized());
    low = std::min(low, x.z());
    high = std::max(high, x.z());
  }
  const double pressure = inward / (2.0 * pi * column_radius * (1.0 + hoop_strain) * (high - low));
  EXPECT_NEAR(pressure, 131.1e3, 2e-3 * 131.1e3);  // 0.2 % of the polygon

  std::vector<StressPoint> peaks;
  for (const double confining_stress : {50e3, 100e3, 150e3})
    peaks.push_back(
        stress_point(confining_stress, strength_of_column(sleeve, hoop_strain, confining_stress)));
  EXPECT_NEAR(strength_of(fit_failure_line(peaks)).cohesion,
              0.5 * exact * std::tan(pi / 4.0 + column_friction / 2.0), 1e-8 * exact);
}
