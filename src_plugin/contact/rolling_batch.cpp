// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
// Nothing here may depend on how Eigen aligns larger matrices, which this changes.
#define EIGEN_DONT_VECTORIZE

#include "contact/rolling_batch.h"

#include "core/vector_units.h"

namespace encased_column {

// A function of its own: what is declared in the loop itself would stay in memory.
double RollingBatch::move_on(int n, double dt, double step)
{
  const double old = seen_[n] < step - 1.0 ? 0.0 : 1.0;  // a new contact starts from zero
  const Vec3 normal(normal_[0][n], normal_[1][n], normal_[2][n]);
  const Vec3 spin(spin_i_[0][n] - spin_j_[0][n], spin_i_[1][n] - spin_j_[1][n],
                  spin_i_[2][n] - spin_j_[2][n]);
  const RollingTrial trial = try_rolling(rolling_spring(n), spin, Turn{cosine_[n], sine_[n]},
                                         normal, dt, old * torque_.at(n));
  torque_.set(n, trial.torque);
  square_[n] = trial.square;
  from_[n] = trial.from;
  return trial.slides(limit(n, dt)) ? 1.0 : 0.0;
}

// Few contacts roll at their limit: the divisions and roots of the slider are theirs alone.
double RollingBatch::slide(double dt)
{
  double loss = 0.0;
  for (int n = 0; n < count_; ++n) {
    const RollingTrial trial{torque_.at(n), square_[n], from_[n]};
    if (!trial.slides(limit(n, dt))) continue;
    const double part = trial.part(limit(n, dt));
    torque_.set(n, part * trial.torque);
    loss += share_[n] * trial.loss(part, rolling_spring(n));
  }
  return loss;
}

// Flat: a call would keep the loop from the vector units.
ENCASE_VECTOR_UNITS [[gnu::flatten]] double RollingBatch::roll(double dt, double step)
{
  double sliding = 0.0;
#pragma omp simd reduction(+ : sliding)
  for (int n = 0; n < count_; ++n) sliding += move_on(n, dt, step);
  const double loss = sliding > 0.0 ? slide(dt) : 0.0;
#pragma omp simd
  for (int n = 0; n < count_; ++n) {
    moment_i_[0][n] -= torque_.x[n];
    moment_i_[1][n] -= torque_.y[n];
    moment_i_[2][n] -= torque_.z[n];
    moment_j_[0][n] += torque_.x[n];
    moment_j_[1][n] += torque_.y[n];
    moment_j_[2][n] += torque_.z[n];
  }
  return loss;
}

}  // namespace encased_column
