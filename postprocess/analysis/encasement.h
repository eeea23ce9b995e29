// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// sin(phi) [-] of a soil without cohesion that bears q = `deviatoric_stress` [Pa] at
/// `confining_stress` [Pa]: the line through the origin that touches the Mohr circle,
///
///   sin(phi) = (sigma1 - sigma3) / (sigma1 + sigma3) = q / (2 sigma3 + q).
///
/// Requires sigma3 > 0 and q > -2 sigma3.
double mobilised_sine(double deviatoric_stress, double confining_stress);

/// Kp = (1 + sin(phi)) / (1 - sin(phi)) = tan^2(45 deg + phi / 2) [-]. Requires sin(phi) < 1.
double passive_coefficient(double sine);

/// Radius [m] at which a ring of `initial_radius` [m] has been stretched by `hoop_strain` [-].
double stretched_radius(double initial_radius, double hoop_strain);

/// Stress [Pa] by which a ring in `hoop_tension` [N/m] confines what it holds: T / r, with r the
/// current `radius` [m].
double confinement_of_ring(double hoop_tension, double radius);

/// q [Pa] a soil with Kp = `passive` bears under `confining_stress` from outside and
/// `extra_confinement` from a sleeve (both [Pa]): q = Kp (sigma3 + dsigma3) - sigma3, as the sleeve
/// stands between the soil and sigma3.
/// Source: closed forms of encased columns in triaxial compression; the sleeve bears nothing along
/// its axis, and no friction passes between it and the soil.
double encased_deviatoric_stress(double passive, double confining_stress, double extra_confinement);

/// Share [-] of the larger of two platen forces that does not arrive at the other, as it went into
/// the sleeve by friction. `friction_force` [N] of either sign, platen stresses [Pa] over the same
/// mean cross section `area` [m^2] > 0. Zero if no platen carries load.
double friction_share(double friction_force, double stress_top, double stress_bottom, double area);

}  // namespace encased_column
