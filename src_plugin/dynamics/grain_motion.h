// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "dynamics/kick_grains.h"
#include "dynamics/mass_scaling.h"

#include <limits>

namespace encased_column {

/// As MovingGrains, with what they do in a step.
struct StepGrains : MovingGrains {
  double* position = nullptr;  ///< [m]
  double* force = nullptr;     ///< [N]
  double* moment = nullptr;    ///< [N m]
  const int* mask = nullptr;   ///< with `group` the grains that move; null: all do
  int group = 0;
};

/// Starts the sums of force [N] and moment [N m] of grains [first, first + count) with their weight
/// at an acceleration [m/s^2].
void start_sums(const StepGrains& grains, int first, int count, const Vec3& acceleration);

/// Velocity Verlet with local damping. The last half kick of a step and the first of the next begin
/// with the same forces: where nothing reads velocities in between they are made in one pass, as
/// the pass takes its time to fetch the grains.
class GrainMotion {
 public:
  double damping = 0.7;                                                ///< alpha [-]
  double free_speed_square = std::numeric_limits<double>::infinity();  ///< [m^2/s^2]
  double longest_way = 0.0;  ///< bound of what a grain went in the last step [m]
  double loss = 0.0;         ///< energy [J] that damping, free speed and changes of mass took out

  /// The forces of a step are made: its last half kick is due.
  void end_step() { kicks_ = Kicks::last_half_is_due; }
  /// Makes the last half kick of a step of `dt` [s], where it is due.
  void complete_step(const StepGrains& grains, MassScaling& masses, double dt);
  /// What is due of the step before, then the first half kick and the way of the next. Grains whose
  /// only force is their weight, at `gravity` [m/s^2], keep to the free speed. With `weight` sums
  /// start again for the next forces, at that acceleration.
  void begin_step(const StepGrains& grains, MassScaling& masses, double dt, const Vec3& gravity,
                  const Vec3* weight);

 private:
  enum class Kicks { complete, last_half_is_due };

  /// To the free speed those that are faster and touch nothing.
  void slow_down(const StepGrains& grains, const MassScaling& masses, int first, int count,
                 const Vec3& gravity);

  Kicks kicks_ = Kicks::complete;
};

}  // namespace encased_column
