// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"
#include "core/vec3.h"

#include <cmath>

namespace encased_column {

/// Mean radius [m] of a cross section [m^2]: that of a circle of the same area.
inline double radius_of_section(double area)
{
  return std::sqrt(area / pi);
}

/// The lateral boundary of a specimen: a rigid cylinder or a sleeve. The specimen stands along z.
class LateralBoundary {
 public:
  virtual ~LateralBoundary() = default;

  /// A point of the center line [m].
  virtual Vec3 axis() const = 0;
  /// Volume [m^3] between two heights [m].
  virtual double enclosed_volume(double z_low, double z_high) const = 0;
  /// Cross section [m^2] at a height [m].
  virtual double cross_section(double z) const = 0;
  /// Mean radius [m] at a height [m].
  virtual double radius_at(double z) const = 0;
  /// Stress [Pa] it lays on the specimen.
  virtual double confining_stress() const = 0;
  /// Work [J] it has done on the specimen; of a sleeve: that was done on it from outside.
  virtual double work() const = 0;
  /// Energy [J] a deformable side stores, moves with and has lost by damping and by yielding and
  /// tearing; a rigid one has none.
  virtual double stored_energy() const { return 0.0; }
  virtual double kinetic_energy() const { return 0.0; }
  virtual double damping_loss() const { return 0.0; }
  virtual double yielding_loss() const { return 0.0; }
  /// How many of `count` grains with `centers` in a row of triples [m] are not on the inner side
  /// between the two heights [m].
  virtual int count_outside(const double* centers, int count, double z_low,
                            double z_high) const = 0;
};

}  // namespace encased_column
