// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

namespace encased_column {

/// A ball of `radius` [m] about `center` [m] in which a packing is measured. `axis` [m] is a point
/// of the column's axis, which stands along z.
struct MeasuringSphere {
  Vec3 center;
  double radius;
  Vec3 axis = Vec3::Zero();

  bool holds(const Vec3& point) const { return (point - center).squaredNorm() < radius * radius; }
};

/// What grains and contacts add up to in a measuring sphere; plain numbers, so that the sums of the
/// ranks add up too. Of grains across the surface the part inside counts as solid, in everything
/// else those count whose center is inside; of contacts those whose point is.
struct SphereSums {
  double solid = 0.0;         ///< inside [m^3]
  double shared = 0.0;        ///< overlaps inside, counted twice in `solid` [m^3]
  double grains = 0.0;        ///< with their center inside
  double grain_volume = 0.0;  ///< of those, whole [m^3]
  double ends = 0.0, without_contact = 0.0, with_one_contact = 0.0;  ///< see ContactCount
  double stress[9] = {};            ///< sums of -force x lever, row by row [J]
  double radial = 0.0, hoop = 0.0;  ///< of the same about the axis [J]
  double contacts = 0.0;
  double sliding = 0.0;
  double force = 0.0;     ///< of their magnitudes [N]
  double fabric[9] = {};  ///< of normal x normal [-]
};

/// Adds a grain at `x` [m] with `radius` [m] that has so many contacts.
void add_grain(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& x, double radius,
               int contacts);

/// Adds what `force` [N] on a grain at `x` [m] does to the stress; `lever` [m] leads from the
/// center of the grain to the contact. One call for each grain of a contact, one for a wall.
void add_contact_end(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& x,
                     const Vec3& force, const Vec3& lever);

/// Adds a contact at `point` [m]: its `normal`, the volume [m^3] its bodies share, the magnitude
/// `force` [N]; `share` is the part of it that is counted here, 1/2 if it is seen twice.
void add_contact(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& point,
                 const Vec3& normal, double shared_volume, double force, bool sliding,
                 double share);

/// What a measuring sphere says; stress positive in compression.
struct SphereMeasure {
  double grains;                          ///< with their center inside
  double porosity;                        ///< [-], overlaps counted twice as solid
  double porosity_less_overlap;           ///< [-]
  double coordination_number;             ///< [-]
  double mechanical_coordination_number;  ///< [-], without rattlers
  Mat3 stress;                            ///< [Pa]
  double axial, radial, hoop;             ///< stress about the axis [Pa]
  Mat3 fabric;                            ///< [-], of trace one
  double sliding_fraction;                ///< of the contacts [-]
  double mean_force;                      ///< [N]
};

/// Stress is Love-Weber's sum over the grains, scaled to the solid that the sphere holds,
///
///   sigma = (1 - n) / (sum V_p) sum_p sum_c (- F x l),
///
/// as grains across the surface count whole or not at all. An empty sphere has porosity one and no
/// stress. Source: Itasca PFC manual, "Measurement region".
SphereMeasure measure(const SphereSums& sums, const MeasuringSphere& sphere);

}  // namespace encased_column
