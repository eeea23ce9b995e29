// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "specimen/lateral_boundary.h"
#include "specimen/platen.h"

namespace encased_column {

/// What the platens and the side of a specimen say at one time; stress [Pa] positive in
/// compression.
struct SpecimenState {
  double height = 0.0;    ///< between the platens [m]
  double volume = 0.0;    ///< enclosed [m^3]
  double radius[3] = {};  ///< at 1/4, 1/2 and 3/4 of the height [m]
  double stress_top = 0.0, stress_bottom = 0.0, confining_stress = 0.0;
};

/// A triaxial specimen: what stands between two platens and inside a lateral boundary. It looks at
/// them when it is asked, and holds nothing itself.
class Specimen {
 public:
  Specimen(const Platens& platens, const LateralBoundary& side) : platens_(platens), side_(&side) {}

  /// Heights [m] between the faces of the platens.
  HeightWindow window() const { return platens_.window(); }
  double height() const { return window().height(); }
  /// Volume [m^3] between the platens.
  double volume() const;
  SpecimenState state() const;
  /// Rate [1/s] at which it is shortened, over its height as it is now.
  double axial_strain_rate() const { return platens_.closing_speed() / height(); }
  /// Unit vector from the center line to a point.
  Vec3 outward(const Vec3& x) const;
  /// How many of `count` grains with `centers` in a row of triples [m] are not inside.
  int count_outside(const double* centers, int count) const;

  const Platens& platens() const { return platens_; }
  const LateralBoundary& side() const { return *side_; }

 private:
  Platens platens_;
  const LateralBoundary* side_;
};

/// Strain [-] by which a length `now` is shorter than `before`; positive in compression.
inline double shortening(double before, double now)
{
  return (before - now) / before;
}

/// Mean stress p = (sigma_1 + 2 sigma_3) / 3 [Pa].
inline double mean_stress(double axial, double confining)
{
  return (axial + 2.0 * confining) / 3.0;
}

/// Deviatoric stress q = sigma_1 - sigma_3 [Pa].
inline double deviatoric_stress(double axial, double confining)
{
  return axial - confining;
}

/// Porosity [-] of a volume that holds `solid` [m^3] of grains.
inline double porosity(double solid, double volume)
{
  return 1.0 - solid / volume;
}

}  // namespace encased_column
