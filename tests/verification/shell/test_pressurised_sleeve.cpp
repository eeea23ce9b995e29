// SPDX-License-Identifier: GPL-2.0-only
#include "static_shell.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/enclosed_volume.h"
#include "shell/pressure_load.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace encased_column;

namespace {

constexpr double radius = 0.05, height = 0.2, encasement_stiffness = 115e3, poisson = 0.3;

ShellConstants sleeve_constants(double thickness)
{
  ShellConstants c;
  c.modulus_hoop = encasement_stiffness / thickness;
  c.poisson = poisson;
  c.thickness = thickness;
  c.density = 900.0;
  return c;
}

SurfaceMesh sleeve_mesh(double edge)
{
  TubeShape shape;
  shape.radius = radius;
  shape.height = height;
  shape.edge = edge;
  return cylinder_mesh(shape);
}

AddLoads inner_pressure(double pressure)
{
  return [pressure](ShellModel& m) {
    add_pressure(m.facet(), m.position(), 0, m.facets(), pressure, {}, m.load());
  };
}

/// w / w0 at x from mid height: ends clamped, axially free; D w'''' + (E t / R^2) w = p.
/// Source: Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, section 115.
double clamped_profile(double x, double thickness)
{
  const double beta =
      std::pow(3.0 * (1.0 - poisson * poisson), 0.25) / std::sqrt(radius * thickness);
  const double a = 0.5 * beta * height, s = std::sinh(2.0 * a) + std::sin(2.0 * a);
  const double even = -2.0 * (std::cos(a) * std::sinh(a) + std::sin(a) * std::cosh(a)) / s;
  const double odd = -2.0 * (std::sin(a) * std::cosh(a) - std::cos(a) * std::sinh(a)) / s;
  return 1.0 + even * std::cos(beta * x) * std::cosh(beta * x) +
         odd * std::sin(beta * x) * std::sinh(beta * x);
}

double mean_ring_radius(const ShellModel& model, int around, int ring)
{
  double sum = 0.0;
  for (int i = ring * around; i < (ring + 1) * around; ++i)
    sum += model.position()[i].head<2>().norm();
  return sum / around;
}

/// Largest difference to the closed form over the height, over w0; small strain: p / 1000.
double clamped_error(double thickness, double edge)
{
  const SurfaceMesh mesh = sleeve_mesh(edge);
  TubeShape shape;
  shape.radius = radius;
  shape.height = height;
  shape.edge = edge;
  const auto [around, rings] = cylinder_counts(shape);
  ShellModel model(mesh, sleeve_constants(thickness), Vec3::UnitZ());
  for (int i = 0; i < around; ++i) {
    model.support().push_back(clamped(i));
    Support top = held_across((rings - 1) * around + i, Vec3::UnitZ());
    top.held_rotation = Mat3::Identity();
    model.support().push_back(top);
  }
  const double pressure = 50.0, w0 = pressure * radius * radius / encasement_stiffness;
  const Relaxation how = relax(model, inner_pressure(pressure), 1e-4, 40000);
  EXPECT_LT(how.unbalanced, 1e-4);
  double worst = 0.0, largest = 0.0;
  for (int ring = 0; ring < rings; ++ring) {
    const double w = (mean_ring_radius(model, around, ring) - radius) / w0;
    const double x = height * ring / (rings - 1) - 0.5 * height;
    worst = std::max(worst, std::abs(w - clamped_profile(x, thickness)));
    largest = std::max(largest, w);
  }
  const FacetState middle = model.facet_state(model.facets() / 2);
  std::printf(
      "clamped sleeve t %4.1f mm, facets %4.1f mm: largest error %.4f w0, largest w %.4f mm at 50 "
      "kPa, "
      "hoop tension %.4f kN/m, %ld steps\n",
      1e3 * thickness, 1e3 * edge, worst, largest * 1e6 * w0, middle.membrane_force(0), how.steps);
  EXPECT_NEAR(middle.membrane_force(0) / (pressure * radius), 1.0, 0.01);
  return worst;
}

}  // namespace

TEST(PressurisedSleeve, ClosedFormHasTheTabulatedValues)
{
  EXPECT_NEAR(clamped_profile(0.09, 0.010), 0.2217, 5e-5);
  EXPECT_NEAR(clamped_profile(0.08, 0.010), 0.5815, 5e-5);
  EXPECT_NEAR(clamped_profile(0.09, 0.001), 0.8823, 5e-5);
  EXPECT_NEAR(clamped_profile(0.1, 0.010), 0.0, 1e-12);
}

TEST(PressurisedSleeve, ClampedTenMillimetreSleeveIsWithinOnePercentAtFiveMillimetreFacets)
{
  const double coarse = clamped_error(0.010, 0.010), fine = clamped_error(0.010, 0.005);
  EXPECT_LT(fine, 0.01);
  EXPECT_LT(fine, coarse);
}

TEST(PressurisedSleeve, ClampedFourMillimetreSleeveIsWithinOnePercentAtFiveMillimetreFacets)
{
  EXPECT_LT(clamped_error(0.004, 0.005), 0.01);
}

// A sleeve with free ends under pressure stays a cylinder: N_axial = 0, so the axial stretch is
// 1 - nu e_h, and p r times that stretch is the nominal hoop tension J e_h.
TEST(PressurisedSleeve, RingAtFiniteStrainCarriesPressureTimesRadius)
{
  for (const double pressure : {50e3, 150e3, 300e3}) {
    const SurfaceMesh mesh = sleeve_mesh(0.005);
    ShellModel model(mesh, sleeve_constants(0.002), Vec3::UnitZ());
    const double volume =
        enclosed_volume(model.facet(), model.position(), 0, model.facets(), HeightWindow{});
    const Relaxation how = relax(model, inner_pressure(pressure), 1e-7, 20000);
    EXPECT_LT(how.unbalanced, 1e-7);
    const double hoop = mean_ring_radius(model, 63, 23) / radius - 1.0;
    const double axial =
        1.0 - (model.position().back().z() - model.position().front().z()) / height;
    const double change =
        enclosed_volume(model.facet(), model.position(), 0, model.facets(), HeightWindow{}) /
            volume -
        1.0;
    const double tension = model.facet_state(model.facets() / 2).membrane_force(0);
    std::printf(
        "ring at %3.0f kPa: hoop strain %.4f, axial %.4f, tension %.3f kN/m, p r %.3f kN/m\n",
        1e-3 * pressure, hoop, axial, 1e-3 * tension, 1e-3 * pressure * radius * (1.0 + hoop));
    EXPECT_NEAR((1.0 + hoop) * (1.0 + hoop) * (1.0 - axial), 1.0 + change, 2e-4);
    EXPECT_NEAR(axial, poisson * hoop, 2e-3 * hoop);
    EXPECT_NEAR(tension / (encasement_stiffness * hoop), 1.0, 2e-3);
    EXPECT_NEAR(tension / (pressure * radius * (1.0 + hoop) * (1.0 - axial)), 1.0, 2e-3);
  }
}
