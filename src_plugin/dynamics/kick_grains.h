// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// A batch of grains: triples of each vector, one number of each scalar per grain.
struct GrainBatch {
  double* velocity;      ///< [m/s]
  double* spin;          ///< [rad/s]
  const double* force;   ///< [N]
  const double* moment;  ///< [N m]
  const double* radius;  ///< [m]
  const double* mass;    ///< inertial [kg]
  int count;             ///< at most `largest_batch`
};

constexpr int largest_batch = 64;

struct BatchKick {
  double loss;     ///< work of the damping [J]
  double fastest;  ///< square of the largest component of a velocity after it [m^2/s^2]
};

/// Half a step `half_step` [s] of damped force and moment on all grains of a batch: kick() of
/// local_damping.h with the vector units of the machine. Velocities and spins are the same on every
/// machine to the last bit; the loss is to the order of its sum (1e-14).
BatchKick kick_grains(const GrainBatch& batch, double alpha, double half_step);

/// The last half of a step and the first of the next, which begin with the same forces: as
/// kick_grains() twice, to the last bit.
struct TwoKicks {
  double loss_of_last;  ///< [J]
  BatchKick first;
};
TwoKicks kick_grains_twice(const GrainBatch& batch, double alpha, double half_step);

}  // namespace encased_column
