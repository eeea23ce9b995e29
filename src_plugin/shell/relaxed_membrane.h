// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/cst_membrane.h"

#include <cmath>

namespace encased_column {

/// Membrane stiffness in axes stretched so that both directions are equally stiff: with the scale
/// a^2 = sqrt(J_hoop / J_axial) strains are (a e_hoop, e_axial / a, shear) and forces (N_hoop / a,
/// a N_axial, N_shear). A congruence: it keeps the energy and where a force turns to compression.
struct EvenStiffness {
  double along;       ///< J = sqrt(J_hoop J_axial), of a strip along either direction [N/m]
  double poisson;     ///< nu sqrt(J_axial / J_hoop) [-]
  double bulk;        ///< J / (1 - poisson) [N/m]
  double deviatoric;  ///< J / (1 + poisson), of which half would be the isotropic G t [N/m]
  double scale;       ///< a [-]
  double inverse;     ///< 1 / a [-]
  double shear;       ///< g: G t over half the deviatoric stiffness [-]
  /// k = (1 + poisson) (1 / g - 1) / 2: a strip at the angle t to an axis has the stiffness
  /// J / (1 + k sin^2 2t) [-]
  double softening;

  /// `hoop`, `axial` are the stiffnesses of strips [N/m], `poisson` the contraction along the axis
  /// under hoop tension; `g` as above.
  static EvenStiffness of(double hoop, double axial, double poisson, double g)
  {
    EvenStiffness even;
    even.along = std::sqrt(hoop * axial);
    even.poisson = poisson * std::sqrt(axial / hoop);
    even.bulk = even.along / (1.0 - even.poisson);
    even.deviatoric = even.along / (1.0 + even.poisson);
    even.scale = std::sqrt(hoop / even.along);
    even.inverse = 1.0 / even.scale;
    even.shear = g;
    even.softening = 0.5 * (1.0 + even.poisson) * (1.0 / g - 1.0);
    return even;
  }
};

/// max(0, x), exactly, without a comparison that would keep the loop from the vector units.
inline double positive_part(double x)
{
  return 0.5 * (x + std::abs(x));
}

/// The line of tension of a wrinkled cloth: cosine and sine of twice its angle to the hoop
/// direction, and the stiffness of a strip along it over that along the axes.
struct TensionLine {
  double x, y, share;
};

/// For half the difference A and half the shear B of the strains, their mean m and the softening k.
///
/// The relaxed energy is the largest of J e^2 / 2 over the directions, J = J0 / (1 + k y^2), e = m
/// + A x + B y, x^2 + y^2 = 1. Where it is stationary, with p = (1 + k) |A|, q = |B|, s = k m,
///
///   p y - q x + s x y = 0.
///
/// So (x, y) is along (p + s x, q), which with x = 1 is the start. Turned on by the angle 2 atan(t)
/// the left side is a polynomial a0 + a1 t + ... of fourth degree, over (1 + t^2)^2: Householder's
/// step of fourth order finds its small root, and as a quotient t turns (x, y) with no square root.
/// Source: Pipkin, IMA J. Appl. Math. 36 (1986) 85-99 for the energy; Householder, The Numerical
/// Treatment of a Single Nonlinear Equation (1970), section 4.4.
inline TensionLine find_tension_line(double m, double a, double b, double k)
{
  constexpr int steps = 3;  // error 1e-15 for g from 0.1 to 10, 2e-10 at g = 0.03
  // Powers up to the 18th of strains from 1e-20 to 1e8 stay within the numbers.
  constexpr double unit = 134217728.0, nothing = 1e-20 * unit;
  const double p = unit * (1.0 + k) * std::abs(a) + nothing, q = unit * std::abs(b) + nothing,
               s = unit * k * m;
  double x = positive_part(p + s), y = q;
  double length = std::sqrt(x * x + y * y);  // of (x, y), 1 after the first step
  double size = 1.0;                         // and after the last one
#pragma GCC unroll 3
  for (int n = 0; n < steps; ++n) {
    const double xy = s * x * y, turned = s * (x * x - y * y), along = length * (p * x + q * y);
    const double a0 = length * (p * y - q * x) + xy, a1 = 2.0 * (along + turned), a2 = -6.0 * xy,
                 a3 = 2.0 * (along - turned);
    const double curved = a0 * a2, square = a1 * a1;
    const double over = -a0 * (square - curved);
    const double under = a1 * (square - 2.0 * curved) + a0 * a0 * a3;
    const double cosine = under * under - over * over, sine = 2.0 * over * under;
    size = length * (under * under + over * over);
    const double scale = n + 1 < steps ? 1.0 / size : 1.0;
    const double before = x;
    x = scale * (x * cosine - y * sine);
    y = scale * (y * cosine + before * sine);
    length = 1.0;
  }
  // Two quotients, 1 / size and 1 / (1 + k y^2), by one division.
  const double soft = size * size + k * y * y;
  const double both = 1.0 / (size * soft);
  const double inverse = both * soft;
  x *= a < 0.0 ? -inverse : inverse;
  y *= b < 0.0 ? -inverse : inverse;
  return {x, y, both * size * size * size};
}

/// Membrane forces (N_hoop, N_axial, N_shear) [N/m] at an elastic strain; `wrinkles`: of the
/// relaxed energy, no principal force is compressive; `softens`: where the shear stiffness is not
/// that of an isotropic membrane. Without branches, for the vector units.
///
/// Relaxed energy: the least energy of any strain that wrinkles can turn the given one into. Taut
/// where both principal forces of the linear law pull; else tension along one line, J e; slack
/// where no line is stretched. Forces are its exact gradient, continuous, and linear homogeneous in
/// the strain, so the energy is half their product with it. Source: Pipkin, IMA J. Appl. Math. 36
/// (1986) 85-99.
template <bool wrinkles, bool softens>
PlaneVector relaxed_force(const EvenStiffness& even, const PlaneVector& strain)
{
  const double hoop = even.scale * strain(0), axial = even.inverse * strain(1);
  const double mean = 0.5 * (hoop + axial), a = 0.5 * (hoop - axial), b = 0.5 * strain(2);
  double middle = even.bulk * mean;  // mean force, then half the difference, and the shear
  double difference = even.deviatoric * a;
  double shear = even.deviatoric * (softens ? even.shear * b : b);
  if constexpr (wrinkles && !softens) {
    // Twice the mean, the half difference, the radius; half of both principal forces.
    const double sum = hoop + axial, apart = hoop - axial;
    const double radius = std::sqrt(apart * apart + strain(2) * strain(2));
    const double pushed = 0.125 * even.bulk * sum - 0.125 * even.deviatoric * radius;
    const double stretched = sum + radius;
    const double smallest = pushed + std::abs(pushed);
    const double largest =
        0.125 * even.along * (stretched + std::abs(stretched)) + even.poisson * smallest;
    const double per_strain = (largest - smallest) / (radius + 2e-150);
    middle = largest + smallest;
    difference = per_strain * apart;
    shear = per_strain * strain(2);
  }
  if constexpr (wrinkles && softens) {
    const bool taut = middle * std::abs(middle) >= difference * difference + shear * shear;
    const auto [x, y, share] = find_tension_line(mean, a, b, even.softening);
    const double half = 0.5 * even.along * share * positive_part(mean + a * x + b * y);
    middle = taut ? middle : half;
    difference = taut ? difference : half * x;
    shear = taut ? shear : half * y;
  }
  return {even.scale * (middle + difference), even.inverse * (middle - difference), shear};
}

}  // namespace encased_column
