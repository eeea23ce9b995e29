// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_material.h"

#include "core/constants.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(ShellMaterial, RigiditiesAreThoseOfPlaneStress)
{
  ShellConstants c = isotropic_shell();
  c.bending_thickness = 0.02;
  const ShellMaterial material(c);
  EXPECT_NEAR(material.membrane()(0, 0), 1e6 * 0.1 / 0.91, 1e-9);
  EXPECT_NEAR(material.membrane()(0, 1), 0.3 * 1e6 * 0.1 / 0.91, 1e-9);
  EXPECT_NEAR(material.membrane()(2, 2), 1e6 * 0.1 / 2.6, 1e-9);
  EXPECT_NEAR(material.bending()(0, 0), 1e6 * 8e-6 / (12.0 * 0.91), 1e-14);
}

TEST(ShellMaterial, BendingThicknessIsTheThicknessUnlessGiven)
{
  EXPECT_EQ(ShellMaterial(isotropic_shell()).constants().bending_thickness, 0.1);
  ShellConstants c = isotropic_shell();
  c.bending_thickness = 0.0;
  EXPECT_FALSE(ShellMaterial(c).bends());
}

TEST(ShellMaterial, StripPulledAndFreeToContractCarriesItsOwnModulus)
{
  const ShellMaterial material(orthotropic_shell());
  // Axial pull: the contraction ratio in the hoop direction is nu E_axial / E_hoop.
  const PlaneVector n = material.membrane_force({-0.3 * 0.25 * 0.01, 0.01, 0.0});
  EXPECT_NEAR(n(0), 0.0, 1e-10);
  EXPECT_NEAR(n(1), 2.5e5 * 0.1 * 0.01, 1e-9);
}

TEST(TensionOnly, IsTheElasticLawWhereBothPrincipalForcesPull)
{
  const ShellMaterial taut(wrinkling_shell()), elastic(isotropic_shell());
  const PlaneVector strain(0.01, -0.002, 0.001);
  EXPECT_NEAR((taut.membrane_force(strain) - elastic.membrane_force(strain)).norm(), 0.0, 1e-10);
}

// nu = 0.3: the strain across at which the force across vanishes is -0.3 of that along.
TEST(TensionOnly, WrinklesWhereTheForceAcrossWouldTurnToCompression)
{
  const ShellMaterial material(wrinkling_shell());
  const PlaneVector taut = material.membrane_force({0.01, -0.0029, 0.0});
  EXPECT_NEAR(taut(1), 1e5 / 0.91 * 0.0001, 1e-9);
  const PlaneVector wrinkled = material.membrane_force({0.01, -0.0031, 0.0});
  EXPECT_NEAR(wrinkled(0), 1e5 * 0.01, 1e-9);
  EXPECT_NEAR(wrinkled(1), 0.0, 1e-12);
}

TEST(TensionOnly, KeepsAUniaxialPullAlongTheWrinkles)
{
  const ShellMaterial material(wrinkling_shell());
  // Principal strains 0.01 at 30 degrees and -0.02 across.
  const double c = std::cos(pi / 6), s = std::sin(pi / 6), e1 = 0.01, e2 = -0.02;
  const PlaneVector strain(e1 * c * c + e2 * s * s, e1 * s * s + e2 * c * c,
                           2.0 * (e1 - e2) * c * s);
  const PlaneVector n = material.membrane_force(strain);
  const double pull = 1e6 * 0.1 * e1;
  EXPECT_NEAR((n - pull * PlaneVector(c * c, s * s, c * s)).norm(), 0.0, 1e-10 * pull);
}

TEST(TensionOnly, IsSlackWhereNoPrincipalStrainIsPositive)
{
  EXPECT_EQ(ShellMaterial(wrinkling_shell()).membrane_force({-0.01, -0.02, 0.005}).norm(), 0.0);
}

TEST(TensionOnly, ForceIsContinuousAtBothBorders)
{
  const ShellMaterial material(wrinkling_shell());
  const auto jump = [&](const PlaneVector& a, const PlaneVector& b) {
    return (material.membrane_force(a) - material.membrane_force(b)).norm();
  };
  EXPECT_LT(jump({0.01, -0.003 + 1e-12, 0}, {0.01, -0.003 - 1e-12, 0}), 1e-6);
  EXPECT_LT(jump({1e-12, -0.02, 0}, {-1e-12, -0.02, 0}), 1e-6);
}

TEST(TensionOnly, ForceIsTheGradientOfTheEnergyInEveryState)
{
  const ShellMaterial material(wrinkling_shell());
  const auto energy = [&](const PlaneVector& e) {
    return ShellMaterial::membrane_energy(e, material.membrane_force(e));
  };
  const double h = 1e-7;
  for (const PlaneVector& e : {PlaneVector(0.02, 0.01, 0.004), PlaneVector(0.01, -0.02, 0.013),
                               PlaneVector(-0.01, 0.004, 0.02), PlaneVector(-0.02, -0.01, 0.001)})
    for (int i = 0; i < 3; ++i) {
      const PlaneVector d = h * PlaneVector::Unit(i);
      EXPECT_NEAR((energy(e + d) - energy(e - d)) / (2.0 * h), material.membrane_force(e)(i), 1e-4);
    }
}

TEST(ShellMaterial, RefusesConstantsWithoutAPositiveEnergyInOneSentence)
{
  const auto message = [](void (*change)(ShellConstants&)) -> std::string {
    ShellConstants c = isotropic_shell();
    change(c);
    try {
      ShellMaterial material(c);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "";
  };
  EXPECT_EQ(message([](ShellConstants& c) { c.thickness = -0.01; }),
            "thickness of the shell must be larger than 0, found -0.01: write the thickness in m");
  EXPECT_NE(message([](ShellConstants& c) { c.poisson = 0.5; }).find("(-1, 0.5), found 0.5"),
            std::string::npos);
  EXPECT_NE(message([](ShellConstants& c) { c.poisson = -1.0; }), "");
  EXPECT_NE(message([](ShellConstants& c) { c.modulus_hoop = 0.0; }), "");
  EXPECT_NE(message([](ShellConstants& c) { c.density = 0.0; }), "");
  EXPECT_NE(message([](ShellConstants& c) { c.modulus_axial = 1e5; }).find("shear_modulus"),
            std::string::npos);
  EXPECT_NE(message([](ShellConstants& c) {
              c.modulus_axial = 1e8;
              c.shear_modulus = 1e5;
            }).find("sqrt(E_hoop / E_axial)"),
            std::string::npos);
}
