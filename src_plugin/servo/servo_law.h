// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
#include <cmath>

namespace encased_column {

/// What a wall feels of the grains.
struct WallLoad {
  double force = 0.0;      ///< with which the grains press on it [N]
  double stiffness = 0.0;  ///< sum of the normal stiffness of its contacts [N/m]

  /// Stress [Pa] on the area [m^2] that carries the force.
  double stress_on(double area) const { return force / area; }
};

/// Speed limit [m/s] of a wall where the deck gives none: a hundred-thousandth of the specimen's
/// `radius` [m] per step `dt` [s], far below the way that grains go in a step.
inline double usual_speed_limit(double radius, double dt)
{
  return 1e-5 * radius / dt;
}

/// Work [J] of a moving wall on the grains: the trapezoid of its force over each step's way is what
/// a spring between wall and grain really takes.
class WallWork {
 public:
  /// At the start of a step, with the force [N] it pressed with so far and the way [m] it goes.
  void begin_step(double force, double way)
  {
    force_before_ = force;
    way_ = way;
  }
  /// At the end of the step, with the force [N] then.
  void end_step(double force) { done_ += 0.5 * (force_before_ + force) * way_; }
  double done() const { return done_; }
  void restore(double work) { done_ = work; }

 private:
  double done_ = 0.0, force_before_ = 0.0, way_ = 0.0;
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

/// Servo with a memory: servo_speed() alone lags behind a specimen that yields at an even speed by
/// the stress that keeps it moving, K v dt / (gain A) - 2.6 % of 150 kPa with 54 000 grains. Here
/// that even speed is learnt and added, so that the lag dies out in some 1 / `learning` steps.
///
/// With the gap x to the target in units of speed, x' = x - gain x - even + yield and even' = even
/// + learning gain x: the roots of z^2 - (2 - gain) z + 1 - gain + learning gain are inside the
/// unit circle for every gain up to 0.8.
struct ServoMemory {
  double even_speed = 0.0;  ///< [m/s]
};
constexpr double servo_learning = 0.02;

/// As servo_speed(), with the even speed; it learns nothing at the limit, and starts again
/// where nothing touches.
inline double steady_servo_speed(const WallLoad& load, double target, double area, double gain,
                                 double dt, double largest_speed, ServoMemory& memory)
{
  const double correction = servo_speed(load, target, area, gain, dt, largest_speed);
  if (load.stiffness <= 0.0) {
    memory.even_speed = 0.0;
    return correction;
  }
  const double speed = correction + memory.even_speed;
  if (std::abs(speed) >= largest_speed) return std::copysign(largest_speed, speed);
  memory.even_speed += servo_learning * correction;
  return speed;
}

}  // namespace encased_column
