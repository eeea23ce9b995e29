// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/encasement.h"
#include "core/constants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

namespace {

constexpr double degree = pi / 180.0;
constexpr double stiffness = 115e3;      // J [N/m], Table 3 of the study
constexpr double initial_radius = 0.05;  // m

// Hoop strain of a specimen that keeps its volume while it gets shorter: (1 + eps_h)^2 (1 - eps_a)
// is one.
double hoop_strain_at_constant_volume(double axial_strain)
{
  return 1.0 / std::sqrt(1.0 - axial_strain) - 1.0;
}

double confinement_at(double axial_strain)
{
  const double hoop_strain = hoop_strain_at_constant_volume(axial_strain);
  return confinement_of_ring(stiffness * hoop_strain,
                             stretched_radius(initial_radius, hoop_strain));
}

}  // namespace

// Values worked out beforehand: 0.579, 2.988 and 6.221 kN/m over the stretched radius.
TEST(ConfinementOfRing, OfTheStudysSleeveAtConstantVolume)
{
  EXPECT_NEAR(confinement_at(0.01), 11.53e3, 5.0);
  EXPECT_NEAR(confinement_at(0.05), 58.24e3, 5.0);
  EXPECT_NEAR(confinement_at(0.10), 118.0e3, 50.0);
}

// The Mohr circle around (sigma1 + sigma3) / 2 that touches a line of slope tan(phi) through the
// origin has the radius sin(phi) (sigma1 + sigma3) / 2.
TEST(MobilisedSine, IsThatOfTheLineThroughTheOriginThatTouchesTheMohrCircle)
{
  for (const double phi : {0.0, 10.0 * degree, 36.5 * degree, 60.0 * degree}) {
    const double sigma3 = 50e3;
    const double centre = sigma3 / (1.0 - std::sin(phi));
    EXPECT_NEAR(mobilised_sine(2.0 * (centre - sigma3), sigma3), std::sin(phi), 1e-12);
  }
}

TEST(PassiveCoefficient, IsTheSquareOfTheTangentOf45DegreesAndHalfTheFrictionAngle)
{
  for (const double phi : {0.0, 10.0 * degree, 36.5 * degree, 60.0 * degree})
    EXPECT_NEAR(passive_coefficient(std::sin(phi)), std::pow(std::tan(pi / 4.0 + phi / 2.0), 2.0),
                1e-12);
}

TEST(EncasedDeviatoricStress, WithoutTensionIsThatOfThePlainSoil)
{
  const double q = 148.8e3, sigma3 = 50e3;
  const double passive = passive_coefficient(mobilised_sine(q, sigma3));
  EXPECT_NEAR(encased_deviatoric_stress(passive, sigma3, 0.0), q, 1e-6);
}

// Published: with 36.3 deg a confinement of 145 kPa is a cohesion of 143.5 kPa, c = dsigma3 / 2
// sqrt(Kp), and 712.0, 857.1 and 1002.3 kPa at 50, 100 and 150 kPa.
TEST(EncasedDeviatoricStress, WithThePublishedCohesionAsConfinementIsThePublishedPeak)
{
  const double passive = passive_coefficient(std::sin(36.3 * degree));
  const double extra = 2.0 * 143.5e3 / std::sqrt(passive);
  EXPECT_NEAR(extra, 145e3, 0.5e3);
  const double sigma3[] = {50e3, 100e3, 150e3}, q[] = {712.0e3, 857.1e3, 1002.3e3};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(encased_deviatoric_stress(passive, sigma3[i], extra), q[i], 0.1e3);
}

// 10 kN on the platen that moves, 4 kN on the other: 6 kN went into the sleeve.
TEST(FrictionShare, IsWhatTheOtherPlatenMissesOfTheLargerForce)
{
  const double area = 0.008;
  EXPECT_NEAR(friction_share(-6e3, 10e3 / area, 4e3 / area, area), 0.6, 1e-12);
  EXPECT_NEAR(friction_share(6e3, 4e3 / area, 10e3 / area, area), 0.6, 1e-12);
  EXPECT_EQ(friction_share(1.0, 0.0, 0.0, area), 0.0);
}
