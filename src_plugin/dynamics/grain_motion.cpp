// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/grain_motion.h"

#include "dynamics/inertia.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

GrainBatch batch(const StepGrains& g, const MassScaling& masses, int first, int count)
{
  return {g.velocity + 3 * first,
          g.spin + 3 * first,
          g.force + 3 * first,
          g.moment + 3 * first,
          g.radius + first,
          masses.inertial_masses().data() + first,
          count};
}

/// Calls `act(first, count)` for all grains that move, in batches.
template <typename Act>
void for_batches(const StepGrains& grains, const Act& act)
{
  for (int first = 0; first < grains.count;) {
    const int last = std::min(first + largest_batch, grains.count);
    int end = grains.mask ? first : last;
    while (end < last && (grains.mask[end] & grains.group)) ++end;
    if (end > first) act(first, end - first);
    first = end > first ? end : first + 1;
  }
}

}  // namespace

void start_sums(const StepGrains& grains, int first, int count, const Vec3& acceleration)
{
  double* const __restrict force = grains.force + 3 * first;
  const double* const __restrict mass = grains.mass + first;
  for (int i = 0; i < count; ++i)
    for (int a = 0; a < 3; ++a) force[3 * i + a] = mass[i] * acceleration[a];
  std::fill_n(grains.moment + 3 * first, 3 * count, 0.0);
}

void GrainMotion::complete_step(const StepGrains& grains, MassScaling& masses, double dt)
{
  if (kicks_ == Kicks::complete) return;
  kicks_ = Kicks::complete;
  for_batches(grains, [&](int first, int count) {
    loss += kick_grains(batch(grains, masses, first, count), damping, 0.5 * dt).loss;
  });
  masses.settle();
  loss += masses.take_loss();
}

// A batch with a grain whose momentum is to be put right between its kicks gets them one by one.
void GrainMotion::begin_step(const StepGrains& grains, MassScaling& masses, double dt,
                             const Vec3& gravity, const Vec3* weight)
{
  const bool is_due = kicks_ == Kicks::last_half_is_due;
  double fastest = 0.0;
  if (is_due) masses.sort_raised();
  for_batches(grains, [&](int first, int count) {
    const GrainBatch kicked = batch(grains, masses, first, count);
    BatchKick kick;
    if (is_due && !masses.raised_before(first + count)) {
      const TwoKicks kicks = kick_grains_twice(kicked, damping, 0.5 * dt);
      loss += kicks.loss_of_last;
      kick = kicks.first;
    } else {
      if (is_due) {
        loss += kick_grains(kicked, damping, 0.5 * dt).loss;
        masses.settle(first + count);
      }
      kick = kick_grains(kicked, damping, 0.5 * dt);
    }
    loss += kick.loss;
    fastest = std::max(fastest, kick.fastest);
    if (3.0 * kick.fastest > free_speed_square) slow_down(grains, masses, first, count, gravity);
    double* const __restrict x = grains.position + 3 * first;
    const double* const __restrict v = grains.velocity + 3 * first;
    for (int k = 0; k < 3 * count; ++k) x[k] += dt * v[k];
    if (weight) start_sums(grains, first, count, *weight);
  });
  longest_way = std::sqrt(3.0 * fastest) * dt;
  masses.settle();
  loss += masses.take_loss();
  kicks_ = Kicks::complete;
}

void GrainMotion::slow_down(const StepGrains& grains, const MassScaling& masses, int first,
                            int count, const Vec3& gravity)
{
  for (int i = first; i < first + count; ++i) {
    double* const v = grains.velocity + 3 * i;
    if (as_vec3(v).squaredNorm() <= free_speed_square ||
        !feels_only_weight(as_vec3(grains.force + 3 * i), grains.mass[i], gravity))
      continue;
    loss += slow_down_to(free_speed_square, masses.inertial_mass(i), v);
  }
}

}  // namespace encased_column
