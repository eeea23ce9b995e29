// SPDX-License-Identifier: GPL-2.0-only
#include "shell/node_motion.h"

#include "core/vector_units.h"
#include "dynamics/local_damping.h"
#include "shell/rotation.h"

#include <algorithm>

namespace encased_column {

namespace {

constexpr int size = nodes_in_batch;
constexpr int widest = 8;  ///< numbers that the widest vector unit takes at once

/// The turns of some nodes, component by component.
struct alignas(64) TurningNodes {
  VectorRow<size> turn;  ///< of the step [rad]
  double x[size], y[size], z[size], w[size];
};

ENCASE_VECTOR_UNITS double kick_numbers(const double* __restrict load,
                                        const double* __restrict rate, int numbers, double alpha,
                                        double* __restrict velocity)
{
  double work = 0.0;
#pragma omp simd reduction(+ : work)
  for (int c = 0; c < numbers; ++c) {
    const double acting = damped(load[c], velocity[c], alpha), before = velocity[c];
    velocity[c] = before + rate[c] * acting;
    work += (load[c] - acting) * (before + velocity[c]);
  }
  return work;
}

/// turned() of all, each by a small angle.
ENCASE_VECTOR_UNITS [[gnu::flatten]] void turn(TurningNodes& nodes, int count)
{
#pragma omp simd
  for (int n = 0; n < count; ++n) {
    const double vx = nodes.turn.x[n], vy = nodes.turn.y[n], vz = nodes.turn.z[n];
    const HalfAngle half = half_of_small(vx * vx + vy * vy + vz * vz);
    const double c = half.cosine, a = half.sine_over_angle * vx, b = half.sine_over_angle * vy,
                 d = half.sine_over_angle * vz;
    const double x = nodes.x[n], y = nodes.y[n], z = nodes.z[n], w = nodes.w[n];
    const double qw = c * w - a * x - b * y - d * z, qx = c * x + a * w + b * z - d * y,
                 qy = c * y + b * w + d * x - a * z, qz = c * z + d * w + a * y - b * x;
    const double scale = 1.0 / std::sqrt(qw * qw + qx * qx + qy * qy + qz * qz);
    nodes.w[n] = scale * qw;
    nodes.x[n] = scale * qx;
    nodes.y[n] = scale * qy;
    nodes.z[n] = scale * qz;
  }
}

}  // namespace

double kick_nodes(const double* load, const double* inertia, int count, double alpha, double dt,
                  double* velocity)
{
  double rate[3 * size], work = 0.0;
  for (int first = 0; first < count; first += size) {
    const int nodes = std::min(size, count - first);
    for (int n = 0; n < nodes; ++n)
      rate[3 * n] = rate[3 * n + 1] = rate[3 * n + 2] = dt / inertia[first + n];
    work += kick_numbers(load + 3 * first, rate, 3 * nodes, alpha, velocity + 3 * first);
  }
  return 0.5 * dt * work;
}

bool turn_nodes(const double* spin, int count, double dt, double* quaternion)
{
  TurningNodes nodes{};  // some more than there are, so that no vector is left over
  double largest = 0.0;
  for (int n = 0; n < count; ++n) {
    const Vec3 turn = dt * as_vec3(spin + 3 * n);
    const double* const q = quaternion + 4 * n;
    largest = std::max(largest, turn.squaredNorm());
    nodes.turn.set(n, turn);
    nodes.x[n] = q[0], nodes.y[n] = q[1], nodes.z[n] = q[2], nodes.w[n] = q[3];
  }
  if (!(largest < small_square)) return false;
  turn(nodes, (count + widest - 1) / widest * widest);
  for (int n = 0; n < count; ++n) {
    double* const q = quaternion + 4 * n;
    q[0] = nodes.x[n], q[1] = nodes.y[n], q[2] = nodes.z[n], q[3] = nodes.w[n];
  }
  return true;
}

}  // namespace encased_column
