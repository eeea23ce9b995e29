// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/periodic_box.h"
#include "core/vec3.h"

#include <vector>

namespace encased_column {

/// A grain as the local strain sees it.
struct MovedGrain {
  Vec3 position;      ///< in the reference state [m]
  Vec3 displacement;  ///< since then [m]
  double diameter;    ///< [m]
};

/// Grains smaller than this part of the mean diameter by volume do not count as neighbours.
constexpr double finest_neighbour = 0.5;

/// Value of a grain with too few neighbours to span a volume.
constexpr double strain_unknown = -1.0;

/// Deviatoric strain [-] about each of `grains`, from how those that stood within `range` [m] of
/// it, itself too, have moved. The displacements are fitted by u = a + H X, least squares weighted
/// by volume and without fines: what rattles in the pores would hide what the load-bearing grains
/// do, and most grains are fines. Of the stretch U, from the polar decomposition of F = 1 + H, the
/// strain is
///
///   e = U - 1,   sqrt(2/3 e':e'),   e' = e - tr(e)/3 1
///
/// so that it is the axial shortening of a cylinder at constant volume, exact under any rotation.
/// For small H this is the symmetric part of the displacement gradient; the fit is exact where the
/// displacement is homogeneous. Across a border of `box` that is periodic the images of grains are
/// neighbours too; its lengths must not have changed since the reference state.
/// Source: fit as in Falk and Langer, Phys. Rev. E 57 (1998) 7192, with volumes as weights and
/// without a fixed center.
std::vector<double> local_deviatoric_strain(const std::vector<MovedGrain>& grains, double range,
                                            const PeriodicBox& box = {});

/// Mean diameter by volume [m], sum of d^4 over sum of d^3; 0 without grains.
double mean_diameter_by_volume(const std::vector<MovedGrain>& grains);

}  // namespace encased_column
