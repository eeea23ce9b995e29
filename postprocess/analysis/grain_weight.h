#pragma once

namespace encased_column {

/// Stress [Pa] of the weight of all grains on the cross section of a specimen, volume over height.
///
/// With grains of `density` [kg/m^3] whose volume is the share 1 - n of the specimen's,
///
///   W / A = density g (1 - n) V / (V / h) = density g (1 - n) h,
///
/// n the porosity [-] that counts overlaps twice, for the grains' mass does the same, and h the
/// height [m], both of one moment: the weight stays while the section grows.
inline double weight_stress(double density, double gravity, double porosity, double height)
{
  return density * gravity * (1.0 - porosity) * height;
}

}  // namespace encased_column
