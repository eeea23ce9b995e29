// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/stable_step.h"

#include "core/eigenvalues.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <vector>

using namespace encased_column;

namespace {

const double pi_value = std::acos(-1.0);

/// Unit vectors to half of the neighbours of a lattice; the other half is opposite.
std::vector<Vec3> simple_cubic()
{
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

std::vector<Vec3> face_centered_cubic()
{
  std::vector<Vec3> half{{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  for (Vec3& n : half) n.normalize();
  return half;
}

/// Largest omega^2 m of plane waves in a lattice of equal spheres (radius 1, mass 1) which move and
/// spin: Bloch's theorem makes the whole lattice one 6 x 6 problem for each wave.
double largest_omega_squared(const std::vector<Vec3>& half, double k_n, double k_t)
{
  using Complex = std::complex<double>;
  using Wide = Eigen::Matrix<Complex, 3, 6>;
  double largest = 0.0;
  const int n_waves = 12;
  for (int a = 0; a <= n_waves; ++a)
    for (int b = 0; b <= n_waves; ++b)
      for (int c = 0; c <= n_waves; ++c) {
        const Vec3 wave = 2.0 * pi_value / n_waves * Vec3(a, b, c);
        Eigen::Matrix<Complex, 6, 6> stiffness = Eigen::Matrix<Complex, 6, 6>::Zero();
        for (const Vec3& n : half) {
          const Complex phase = std::exp(Complex(0.0, wave.dot(n)));
          Mat3 cross;  // w x n
          cross << 0, n.z(), -n.y(), -n.z(), 0, n.x(), n.y(), -n.x(), 0;
          Wide relative;
          relative << (1.0 - phase) * Mat3::Identity().cast<Complex>(),
              (1.0 + phase) * cross.cast<Complex>();
          const Mat3 springs =
              k_n * n * n.transpose() + k_t * (Mat3::Identity() - n * n.transpose());
          stiffness += relative.adjoint() * springs.cast<Complex>() * relative;
        }
        Eigen::Matrix<double, 6, 1> root_mass;
        root_mass << 1, 1, 1, std::sqrt(0.4), std::sqrt(0.4), std::sqrt(0.4);
        const Eigen::Matrix<Complex, 6, 6> scaled = root_mass.cwiseInverse().asDiagonal() *
                                                    stiffness *
                                                    root_mass.cwiseInverse().asDiagonal();
        Eigen::Matrix<double, 12, 12> real;  // the same eigenvalues, each twice
        real << scaled.real(), -scaled.imag(), scaled.imag(), scaled.real();
        largest = std::max(largest, symmetric_eigenvalues(real).maxCoeff());
      }
  return largest;
}

double decisive_stiffness(const std::vector<Vec3>& half, double k_n, double k_t)
{
  GrainStiffness grain;
  for (const Vec3& n : half) {
    grain.add(n, k_n, k_t);
    grain.add(-n, k_n, k_t);
  }
  return grain.decisive();
}

}  // namespace

TEST(GrainStiffness, OfOneContactIsItsNormalStiffnessAlongAndItsShearStiffnessAcross)
{
  GrainStiffness grain;
  grain.add({0.0, 0.0, -1.0}, 5.0, 2.0);
  EXPECT_EQ(grain.translation, Vec3(2.0, 2.0, 5.0));
  EXPECT_EQ(grain.rotation, Vec3(5.0, 5.0, 0.0));
  EXPECT_EQ(grain.decisive(), 5.0);
}

TEST(GrainStiffness, IsDecidedByRotationWhereShearIsStiff)
{
  GrainStiffness grain;
  grain.add({1.0, 0.0, 0.0}, 1.0, 100.0);
  EXPECT_DOUBLE_EQ(grain.decisive(), 250.0);
}

TEST(GrainStiffness, AddsItsContactsUp)
{
  GrainStiffness grain;
  for (int n = 0; n < 3; ++n) grain.add(Vec3(1.0, 2.0, 2.0) / 3.0, 9.0, 0.0);
  EXPECT_NEAR((grain.translation - Vec3(3.0, 12.0, 12.0)).norm(), 0.0, 1e-14);
}

// Central differences are stable up to dt = 2 / omega: with f = 1, omega^2 m / k must stay below 4.
TEST(StableStep, IsStableForEveryWaveInACubicLattice)
{
  for (const double kappa : {0.01, 0.3, 1.0, 3.5})
    for (const auto& lattice : {simple_cubic(), face_centered_cubic()}) {
      const double ratio = largest_omega_squared(lattice, 1.0, 1.0 / kappa) /
                           decisive_stiffness(lattice, 1.0, 1.0 / kappa);
      EXPECT_LT(ratio, 4.0) << "kappa " << kappa;
      EXPECT_GT(ratio, 1.0) << "kappa " << kappa << ": the step could be far larger";
    }
}

TEST(StableStep, OfOneMassOnOneSpringIsItsPeriodOverTwoPi)
{
  const double period = 2.0 * pi_value * std::sqrt(0.5 / 2e5);
  EXPECT_DOUBLE_EQ(stable_step(0.5, 2e5, 0.8), 0.8 * period / (2.0 * pi_value));
}

TEST(MassForStep, IsTheMassOfWhichThatStepIsStable)
{
  const double mass = mass_for_step(1.0, 3e4, 0.8);
  EXPECT_DOUBLE_EQ(stable_step(mass, 3e4, 0.8), 1.0);
}

// A grain on one wall contact turns against k_t r^2 with 2/5 m r^2: softer in rotation than along
// the normal only while k_t < 0.4 k_n.
TEST(DecisiveRatio, IsRotationWhereTheShearSpringIsStiff)
{
  EXPECT_EQ(decisive_ratio(3.5, false), 1.0);
  EXPECT_DOUBLE_EQ(decisive_ratio(1.0, false), 2.5);
  EXPECT_DOUBLE_EQ(decisive_ratio(0.01, false), 250.0);
  EXPECT_DOUBLE_EQ(decisive_ratio(1.0, true), 5.0);
}

// The largest stiffness of one contact, over all directions, is an eigenvalue of its matrices; the
// sums per axis of an oblique contact stay below it.
TEST(WallStiffness, IsTheLargestEigenvalueOfAContactInAnyDirection)
{
  for (const double k_s : {30.0, 1.0, 0.2}) {
    const double k_n = 1.0;
    const Vec3 n = Vec3(1.0, 1.0, 0.2).normalized();
    const Mat3 along = n * n.transpose(), across = Mat3::Identity() - along;
    const double largest = std::max(symmetric_eigenvalues(k_n * along + k_s * across).maxCoeff(),
                                    symmetric_eigenvalues(k_s / 0.4 * across).maxCoeff());
    EXPECT_NEAR(wall_stiffness(k_n, k_s, false), largest, 1e-14 * largest) << "k_s " << k_s;
    GrainStiffness grain;
    grain.add(n, k_n, k_s);
    EXPECT_LT(grain.decisive(), (1.0 - 1e-3) * largest);
    grain.wall = wall_stiffness(k_n, k_s, false);
    EXPECT_EQ(grain.decisive(), grain.wall);
  }
}
