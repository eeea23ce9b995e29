// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// A step `dt` [s] of damped loads on `count` nodes: kick() of local_damping.h with the vector
/// units of the machine. Triples of loads and velocities and one inertia a node: forces and masses,
/// or moments and moments of inertia. Velocities are the same on every machine to the last bit; the
/// work of the damping [J], which it returns, is to the order of its sum (1e-14).
double kick_nodes(const double* load, const double* inertia, int count, double alpha, double dt,
                  double* velocity);

constexpr int nodes_in_batch = 32;

/// Turns `count` nodes, at most a batch, on by a step `dt` [s], as turned() does: triples of spins
/// [rad/s], quaternions (x, y, z, w). Returns false, and turns none, where one would turn by more
/// than half_of_small() is good for.
bool turn_nodes(const double* spin, int count, double dt, double* quaternion);

}  // namespace encased_column
