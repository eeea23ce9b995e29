// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/kick_grains.h"

#include "core/vector_units.h"
#include "dynamics/local_damping.h"

namespace encased_column {

namespace {

/// Half a kick of one component: its velocity after it, and the work of the damping, without half
/// the step, on top of `loss`.
[[gnu::always_inline]] inline double kick_component(double force, double rate, double alpha,
                                                    double before, double& loss)
{
  const double acting = damped(force, before, alpha);
  const double after = before + rate * acting;
  loss += (force - acting) * (before + after);
  return after;
}

/// Half a kick of `count` components; rate [s/kg] of each. The loss is without half the step.
[[gnu::always_inline]] inline BatchKick kick_components(int count, const double* __restrict force,
                                                        const double* __restrict rate, double alpha,
                                                        double* __restrict velocity)
{
  double loss = 0.0, fastest = 0.0;
#pragma omp simd reduction(+ : loss) reduction(max : fastest)
  for (int k = 0; k < count; ++k) {
    const double after = kick_component(force[k], rate[k], alpha, velocity[k], loss);
    velocity[k] = after;
    fastest = after * after > fastest ? after * after : fastest;
  }
  return {loss, fastest};
}

/// As kick_components() twice. How fast grains are after the first is not asked.
[[gnu::always_inline]] inline TwoKicks kick_components_twice(int count,
                                                             const double* __restrict force,
                                                             const double* __restrict rate,
                                                             double alpha,
                                                             double* __restrict velocity)
{
  double last = 0.0, first = 0.0, fastest = 0.0;
#pragma omp simd reduction(+ : last, first) reduction(max : fastest)
  for (int k = 0; k < count; ++k) {
    const double between = kick_component(force[k], rate[k], alpha, velocity[k], last);
    const double after = kick_component(force[k], rate[k], alpha, between, first);
    velocity[k] = after;
    fastest = after * after > fastest ? after * after : fastest;
  }
  return {last, {first, fastest}};
}

/// Half a step over the inertia of each component of a batch.
struct Rates {
  double of_velocity[3 * largest_batch], of_spin[3 * largest_batch];

  [[gnu::always_inline]] Rates(const GrainBatch& batch, double half_step)
  {
    double by_force[largest_batch], by_moment[largest_batch];
#pragma omp simd
    for (int i = 0; i < batch.count; ++i) {
      const double square = 0.4 * batch.radius[i] * batch.radius[i];
      by_moment[i] = half_step / (batch.mass[i] * square);  // one division for both
      by_force[i] = square * by_moment[i];
    }
    for (int i = 0; i < batch.count; ++i)
      for (int a = 0; a < 3; ++a) {
        of_velocity[3 * i + a] = by_force[i];
        of_spin[3 * i + a] = by_moment[i];
      }
  }
};

}  // namespace

ENCASE_VECTOR_UNITS
BatchKick kick_grains(const GrainBatch& batch, double alpha, double half_step)
{
  const Rates rates(batch, half_step);
  const int count = 3 * batch.count;
  const BatchKick way =
      kick_components(count, batch.force, rates.of_velocity, alpha, batch.velocity);
  const BatchKick turn = kick_components(count, batch.moment, rates.of_spin, alpha, batch.spin);
  return {0.5 * half_step * (way.loss + turn.loss), way.fastest};
}

ENCASE_VECTOR_UNITS
TwoKicks kick_grains_twice(const GrainBatch& batch, double alpha, double half_step)
{
  const Rates rates(batch, half_step);
  const int count = 3 * batch.count;
  const TwoKicks way =
      kick_components_twice(count, batch.force, rates.of_velocity, alpha, batch.velocity);
  const TwoKicks turn =
      kick_components_twice(count, batch.moment, rates.of_spin, alpha, batch.spin);
  return {0.5 * half_step * (way.loss_of_last + turn.loss_of_last),
          {0.5 * half_step * (way.first.loss + turn.first.loss), way.first.fastest}};
}

}  // namespace encased_column
