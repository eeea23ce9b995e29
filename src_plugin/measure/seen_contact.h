#pragma once

#include "core/vec3.h"
#include "measure/sphere_overlap.h"

namespace encased_column {

/// A contact as what is measured of a packing sees it: the grain it is seen from, i, and what
/// stands at its other end, a grain j or a wall.
struct SeenContact {
  Vec3 at_i;        ///< center [m]
  double radius_i;  ///< [m]
  bool is_wall;     ///< j is no grain
  bool counts_j;    ///< j counts here too, and not where it is seen from j
  Vec3 at_j;        ///< of a grain that counts [m]
  double radius_j;  ///< of a grain [m]
  Vec3 normal;      ///< from i to j
  Vec3 force;       ///< on i [N]
  double arm;       ///< from the center of i to the contact [m]
  double length;    ///< from the center of i to that of j or to the wall [m]
  double share;     ///< part of it that counts here: 1, or 1/2 if it is seen from both ends
  bool sliding;
  double stored_energy;  ///< [J]

  Vec3 lever_i() const { return arm * normal; }  ///< from the center to the contact [m]
  Vec3 lever_j() const { return -(length - arm) * normal; }
  /// What both bodies claim [m^3].
  double shared_volume() const
  {
    return is_wall ? sphere_cap_volume(radius_i, length)
                   : sphere_overlap_volume(radius_i, radius_j, length);
  }
};

}  // namespace encased_column
