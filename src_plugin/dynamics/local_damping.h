#pragma once

#include <cmath>

namespace encased_column {

/// Force or moment component after local (non-viscous) damping: F - alpha |F| sign(v).
///
/// It takes alpha |F| from a motion the force drives and adds it to one the force brakes; steady
/// motion (F = 0) is not damped, and a body at rest (v = 0) feels the full force.
/// Source: Cundall (1987), in Analytical and computational methods in engineering rock mechanics,
/// 129-163; Itasca PFC, "local damping".
inline double damped(double force, double velocity, double alpha)
{
  const double sense = static_cast<double>(velocity > 0.0) - static_cast<double>(velocity < 0.0);
  return force - alpha * std::abs(force) * sense;
}

/// Half a step of one component: speeds `velocity` up by the damped `force` and returns the work
/// [J] the damping took out. `rate` is half the step divided by the inertia.
/// The work is exact: damping force times the mean velocity of the half step times its length.
inline double half_kick(double force, double alpha, double rate, double half_step, double& velocity)
{
  const double after_damping = damped(force, velocity, alpha);
  const double before = velocity;
  velocity += rate * after_damping;
  return (force - after_damping) * 0.5 * (before + velocity) * half_step;
}

}  // namespace encased_column
