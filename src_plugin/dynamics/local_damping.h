// SPDX-License-Identifier: GPL-2.0-only
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
  const double resisted = std::copysign(alpha * std::abs(force), velocity);
  return velocity == 0.0 ? force : force - resisted;
}

/// The three components of `force` (or moment) for a time `span` [s], half a step of a grain or a
/// step of a node: speeds `velocity` up by the damped force and returns the work [J] the damping
/// took out. `rate` is the span over the inertia. The work is exact: damping force times the mean
/// velocity of the span times its length.
inline double kick(const double* force, double alpha, double rate, double span, double* velocity)
{
  double work[3];  // apart, so that one component need not wait for the sum of the others
  for (int a = 0; a < 3; ++a) {
    const double acting = damped(force[a], velocity[a], alpha);
    const double before = velocity[a];
    velocity[a] += rate * acting;
    work[a] = (force[a] - acting) * (before + velocity[a]);
  }
  return 0.5 * span * (work[0] + work[1] + work[2]);
}

}  // namespace encased_column
