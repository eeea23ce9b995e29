#pragma once

#include <algorithm>
#include <cmath>

namespace encased_column {

/// What a wall feels of the grains.
struct WallLoad {
  double force = 0.0;      ///< with which the grains press on it [N]
  double stiffness = 0.0;  ///< sum of the normal stiffness of its contacts [N/m]
};

/// Speed [m/s] towards the specimen that brings a wall to the stress `target` [Pa].
///
/// A step `dt` [s] at speed v changes the force by K v dt, so v = gain (target - stress) A / (K dt)
/// closes the fraction `gain` of the gap in one step. Nothing in contact, or so little that the
/// law asks for more: the wall approaches (or retreats) at `largest_speed`.
/// Source: Itasca PFC, wall servo control.
inline double servo_speed(const WallLoad& load, double target, double area, double gain, double dt,
                          double largest_speed)
{
  if (load.stiffness <= 0.0) return target > 0.0 ? largest_speed : 0.0;
  const double speed = gain * (target * area - load.force) / (load.stiffness * dt);
  return std::clamp(speed, -largest_speed, largest_speed);
}

}  // namespace encased_column
