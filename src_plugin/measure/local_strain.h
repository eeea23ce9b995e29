#pragma once

#include "core/vec3.h"

#include <vector>

namespace encased_column {

/// A grain as the local strain sees it.
struct MovedGrain {
  Vec3 position;      ///< in the reference state [m]
  Vec3 displacement;  ///< since then [m]
  double volume;      ///< its weight in the mean over neighbours [m^3]
};

/// Value of a grain with too few neighbours to span a volume.
constexpr double strain_unknown = -1.0;

/// Deviatoric strain [-] about each of `grains`, from how all that stood within `range` [m] of it,
/// itself too, have moved. The displacements are fitted by u = a + H X, least squares weighted by
/// volume: fines that rattle in the pores then do not hide what the load-bearing grains do. Of the
/// stretch U, from the polar decomposition of F = 1 + H, the strain is
///
///   e = U - 1,   sqrt(2/3 e':e'),   e' = e - tr(e)/3 1
///
/// so that it is the axial shortening of a cylinder at constant volume, exact under any rotation.
/// For small H this is the symmetric part of the displacement gradient; the fit is exact where the
/// displacement is homogeneous.
/// Source: fit as in Falk and Langer, Phys. Rev. E 57 (1998) 7192, with volumes as weights and
/// without a fixed center.
std::vector<double> local_deviatoric_strain(const std::vector<MovedGrain>& grains, double range);

/// Mean diameter by volume [m], sum of d^4 over sum of d^3; 0 without grains.
double mean_diameter_by_volume(const std::vector<double>& diameters);

}  // namespace encased_column
