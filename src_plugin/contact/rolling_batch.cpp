// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
// Nothing here may depend on how Eigen aligns larger matrices, which this changes.
#define EIGEN_DONT_VECTORIZE

#include "contact/rolling_batch.h"

#include "core/vector_units.h"

namespace encased_column {

// A function of its own: what is declared in the loop itself would stay in memory.
double RollingBatch::roll_one(int n, double dt, double step)
{
  const double old = seen_[n] < step - 1.0 ? 0.0 : 1.0;  // a new contact starts from zero
  Vec3 torque = old * torque_.at(n);
  const Vec3 normal(normal_[0][n], normal_[1][n], normal_[2][n]);
  const double loss = advance_rolling_torque(shear_stiffness_[n], rolling_friction_[n],
                                             radius_of_rolling(n), normal_force_[n], turning_.at(n),
                                             Turn{cosine_[n], sine_[n]}, normal, dt, torque);
  torque_.set(n, torque);
  return share_[n] * loss;
}

// Flat: a call would keep the loop from the vector units.
ENCASE_VECTOR_UNITS [[gnu::flatten]] double RollingBatch::roll(double dt, double step)
{
  double loss = 0.0;
#pragma omp simd reduction(+ : loss)
  for (int n = 0; n < count_; ++n) loss += roll_one(n, dt, step);
  return loss;
}

}  // namespace encased_column
