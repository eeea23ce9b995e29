// SPDX-License-Identifier: GPL-2.0-only
#include "contact/grain_reach.h"

#include "core/vector_units.h"

#include <cmath>
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
  rule_ = rule;
  reach_.assign(grains.all, rule.least);
  for (int i = 0; i < grains.owned; ++i)
    reach_[i] = rule.known_beyond(rule.reach(grains.radius[i], as_vec3(grains.velocity + 3 * i)),
                                  grains.radius[i], as_vec3(grains.center + 3 * i));
  forget_wider();
  left_ = 0;
  round_off_ = 1e-9 * rule.least;
  spare_ = rule.least;
}

ReachAccount::Answer ReachAccount::look(const ListedGrains& grains, const double* listed)
{
  spare_ = least_gap(grains, listed);
  if (!(spare_ < 0.0)) return Answer::lists_hold;
  for (int i = 0; i < grains.owned; ++i) {
    const double gone = (as_vec3(grains.center + 3 * i) - as_vec3(listed + 3 * i)).norm();
    if (!(gone > reach_[i])) continue;
    const double wider = rule_.known_beyond(
        rule_.wider_reach(grains.radius[i], as_vec3(grains.velocity + 3 * i), gone),
        grains.radius[i], as_vec3(listed + 3 * i));
    if (++left_ > most_wider || !(wider > 1.1 * gone)) return Answer::lists_end;
    set_reach(i, wider);
  }
  spare_ = least_gap(grains, listed);
  return Answer::some_are_wider;
}

/// Without a branch: most looks find that all are inside.
ENCASE_VECTOR_UNITS
double ReachAccount::least_gap(const ListedGrains& grains, const double* listed) const
{
  const double* const center = grains.center;
  const double* const reach = reach_.data();
  double least = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : least)
  for (int i = 0; i < grains.owned; ++i) {
    const double x = center[3 * i] - listed[3 * i], y = center[3 * i + 1] - listed[3 * i + 1],
                 z = center[3 * i + 2] - listed[3 * i + 2];
    const double gap = reach[i] - std::sqrt(x * x + y * y + z * z);
    least = gap < least ? gap : least;
  }
  return least;
}

}  // namespace encased_column
