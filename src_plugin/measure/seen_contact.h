// SPDX-License-Identifier: GPL-2.0-only
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

/// What the force [N] on a grain at `lever` [m] from its center adds to V times the stress along
/// the unit vector `direction` [J], positive in compression.
///
/// Love-Weber: V sigma = - sum over contacts of force x lever; in equilibrium the mean stress of
/// the grain. Source: Weber, Bull. Liaison Ponts et Chaussees 20 (1966) 3-1 to 3-20.
inline double love_weber(const Vec3& force, const Vec3& lever, const Vec3& direction)
{
  return -force.dot(direction) * lever.dot(direction);
}

/// Contacts counted over a specimen; a contact of two grains has two ends, one with a wall has one.
struct ContactCount {
  double grains = 0.0;
  double ends = 0.0;             ///< of all contacts
  double without_contact = 0.0;  ///< grains that touch nothing
  double with_one_contact = 0.0;
};

/// Mean number of contacts per grain [-].
inline double coordination_number(const ContactCount& n)
{
  return n.grains > 0.0 ? n.ends / n.grains : 0.0;
}

/// Mean number of contacts [-] per grain that bears load: grains with none or one contact and
/// those contacts left out.
/// Source: Thornton (2000), Geotechnique 50, 43-53, "mechanical coordination number".
inline double mechanical_coordination_number(const ContactCount& n)
{
  const double bearing = n.grains - n.without_contact - n.with_one_contact;
  return bearing > 0.0 ? (n.ends - n.with_one_contact) / bearing : 0.0;
}

}  // namespace encased_column
