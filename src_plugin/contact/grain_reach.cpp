// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_reach.h"

#include <limits>

namespace encased_column {

double sum_of_speeds(const ListedGrains& grains)
{
  double sum = 0.0;
  for (int i = 0; i < grains.owned; ++i) sum += as_vec3(grains.velocity + 3 * i).norm();
  return sum;
}

void ReachAccount::start(const ListedGrains& grains, const ReachRule& rule)
{
  owned_ = grains.owned;
  reach_.resize(grains.all);
  for (int i = 0; i < grains.all; ++i)
    reach_[i] = rule.reach(grains.radius[i], as_vec3(grains.velocity + 3 * i));
  round_off_ = 1e-9 * rule.least;
  spare_ = rule.least;
}

bool ReachAccount::is_left(const double* centers, const double* listed, double way)
{
  spare_ -= way + round_off_;
  if (spare_ > 0.0) return false;
  spare_ = std::numeric_limits<double>::infinity();
  for (int i = 0; i < owned_; ++i) {
    const double gone = (as_vec3(centers + 3 * i) - as_vec3(listed + 3 * i)).norm();
    spare_ = std::min(spare_, reach_[i] - gone);
  }
  return spare_ < 0.0;
}

}  // namespace encased_column
