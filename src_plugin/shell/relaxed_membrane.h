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

/// Cosine and sine of twice the angle between a wrinkled cloth's line of tension and the hoop
/// direction, for half the difference A and half the shear B of the strains, their mean m and the
/// softening k.
///
/// The relaxed energy is the largest of J e^2 / 2 over the directions, J = J0 / (1 + k y^2), e = m
/// + A x + B y, x^2 + y^2 = 1. Where it is stationary, (1 + k) A y - B x + k m x y = 0, thus
///
///   x = (1 + k) A / (u - k m),   y = B / u
///
/// with one u > 0, k m where the length of (x, y) is 1: by Newton's method on 1 / length - 1, which
/// is concave in u and almost straight, from the left. Without softening the first step is exact.
/// Source: Pipkin, IMA J. Appl. Math. 36 (1986) 85-99 for the energy; the secular equation and its
/// solution as in More and Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553-572.
inline void find_tension_line(double m, double a, double b, double k, double& x, double& y)
{
  constexpr int steps = 5;  // relative error 1e-14 for g above 0.1 (k below 5), 4e-9 at g = 0.03
  constexpr double nothing = 1e-150;
  const double p = (1.0 + k) * std::abs(a) + nothing, q = std::abs(b) + nothing, shift = k * m;
  double u = q + positive_part(shift + p - q);
#pragma GCC unroll 5
  for (int n = 0; n < steps; ++n) {
    const double inverse = 1.0 / (u * (u - shift));
    const double from_x = u * inverse, from_y = (u - shift) * inverse;
    const double xx = p * p * from_x * from_x, yy = q * q * from_y * from_y;
    const double square = xx + yy;
    u += square * (std::sqrt(square) - 1.0) / (xx * from_x + yy * from_y);
  }
  const double inverse = 1.0 / (u * (u - shift));
  x = p * u * inverse;
  y = q * (u - shift) * inverse;
  x = a < 0.0 ? -x : x;
  y = b < 0.0 ? -y : y;
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
    const double radius = std::sqrt(a * a + b * b);
    const double smallest = positive_part(middle - even.deviatoric * radius);
    const double largest = even.along * positive_part(mean + radius) + even.poisson * smallest;
    const double per_strain = 0.5 * (largest - smallest) / (radius + 1e-150);
    middle = 0.5 * (largest + smallest);
    difference = per_strain * a;
    shear = per_strain * b;
  }
  if constexpr (wrinkles && softens) {
    const bool taut = middle >= std::sqrt(difference * difference + shear * shear);
    double x, y;
    find_tension_line(mean, a, b, even.softening, x, y);
    const double half =
        0.5 * even.along * positive_part(mean + a * x + b * y) / (1.0 + even.softening * y * y);
    middle = taut ? middle : half;
    difference = taut ? difference : half * x;
    shear = taut ? shear : half * y;
  }
  return {even.scale * (middle + difference), even.inverse * (middle - difference), shear};
}

}  // namespace encased_column
