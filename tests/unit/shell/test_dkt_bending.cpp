// SPDX-License-Identifier: GPL-2.0-only
#include "shell/dkt_bending.h"

#include "core/eigenvalues.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const Triangle2 distorted = (Triangle2() << 0.1, 1.3, 0.4, -0.2, 0.1, 0.8).finished();
using PlateVector = Eigen::Matrix<double, 9, 1>;

/// Nodal (w, dw/dy, -dw/dx) of w = c + bx x + by y + kx x^2/2 + ky y^2/2 + kxy x y.
PlateVector quadratic(double c, double bx, double by, double kx, double ky, double kxy)
{
  PlateVector out;
  for (int i = 0; i < 3; ++i) {
    const double x = distorted(0, i), y = distorted(1, i);
    out(3 * i) = c + bx * x + by * y + kx * x * x / 2 + ky * y * y / 2 + kxy * x * y;
    out(3 * i + 1) = by + ky * y + kxy * x;
    out(3 * i + 2) = -(bx + kx * x + kxy * y);
  }
  return out;
}

}  // namespace

TEST(DktBending, CurvatureOfAQuadraticSurfaceIsExactEverywhere)
{
  const PlateVector freedoms = quadratic(0.3, -0.2, 0.7, 2.0, -3.0, 0.5);
  for (const Vec3& point : {Vec3(1, 0, 0), Vec3(0.2, 0.3, 0.5), Vec3(0.0, 0.5, 0.5)}) {
    const PlaneVector curvature = dkt_curvature(distorted, point) * freedoms;
    EXPECT_NEAR((curvature - PlaneVector(2.0, -3.0, 1.0)).norm(), 0.0, 1e-12);
  }
}

TEST(DktBending, EnergyOfConstantCurvatureIsExact)
{
  const Mat3 rigidity = ShellMaterial(orthotropic_shell()).bending();
  const PlateStiffness stiffness = dkt_stiffness(distorted, rigidity);
  const double area = triangle_area(distorted), k = 0.02;
  const std::array<PlateVector, 3> field{quadratic(0, 0, 0, k, 0, 0), quadratic(0, 0, 0, 0, k, 0),
                                         quadratic(0, 0, 0, 0, 0, k)};
  const std::array<PlaneVector, 3> curvature{PlaneVector(k, 0, 0), PlaneVector(0, k, 0),
                                             PlaneVector(0, 0, 2.0 * k)};
  for (int i = 0; i < 3; ++i) {
    const double found = 0.5 * field[i].dot(stiffness * field[i]);
    const double expected = 0.5 * area * curvature[i].dot(rigidity * curvature[i]);
    EXPECT_NEAR(found / expected, 1.0, 1e-12) << "field " << i;
  }
}

TEST(DktBending, HasThreeRigidMotionsAndSixStiffModes)
{
  const PlateStiffness stiffness =
      dkt_stiffness(distorted, ShellMaterial(isotropic_shell()).bending());
  for (const PlateVector& rigid :
       {quadratic(1, 0, 0, 0, 0, 0), quadratic(0, 1, 0, 0, 0, 0), quadratic(0, 0, 1, 0, 0, 0)})
    EXPECT_NEAR((stiffness * rigid).norm() / stiffness.norm(), 0.0, 1e-14);
  const Eigen::VectorXd modes = symmetric_eigenvalues(stiffness);
  EXPECT_GT(modes(3), 1e-6 * modes(8));
}

// Three nodes at different heights lie in a turned plane: there the tilts against that plane carry
// the same energy, so the corotational form loses nothing.
TEST(DktBending, TiltStiffnessGivesTheEnergyOfThePlateAgainstTheTurnedPlane)
{
  const Mat3 rigidity = ShellMaterial(isotropic_shell()).bending();
  PlateVector freedoms;
  freedoms << 0.1, 0.02, -0.3, -0.2, 0.4, 0.1, 0.05, -0.1, 0.2;
  const Triangle2 gradient = area_coordinate_gradients(distorted);
  const Vec3 rise(freedoms(0), freedoms(3), freedoms(6));
  const Vec2 slope = gradient * rise;
  Eigen::Matrix<double, 6, 1> tilt;
  for (int i = 0; i < 3; ++i) {
    tilt(2 * i) = freedoms(3 * i + 1) - slope.y();
    tilt(2 * i + 1) = freedoms(3 * i + 2) + slope.x();
  }
  const double whole = freedoms.dot(dkt_stiffness(distorted, rigidity) * freedoms);
  EXPECT_NEAR(tilt.dot(dkt_tilt_stiffness(distorted, rigidity) * tilt) / whole, 1.0, 1e-12);
}
