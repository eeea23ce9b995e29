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
  rule_ = rule;
  reach_.resize(grains.all);
  for (int i = 0; i < grains.all; ++i)
    reach_[i] = rule.reach(grains.radius[i], as_vec3(grains.velocity + 3 * i));
  wider_.clear();
  left_ = 0;
  round_off_ = 1e-9 * rule.least;
  spare_ = rule.least;
}

ReachAccount::Answer ReachAccount::look(const ListedGrains& grains, const double* listed)
{
  Answer answer = Answer::lists_hold;
  spare_ = std::numeric_limits<double>::infinity();
  for (int i = 0; i < grains.owned; ++i) {
    const double gone = (as_vec3(grains.center + 3 * i) - as_vec3(listed + 3 * i)).norm();
    if (gone > reach_[i]) {
      const double wider =
          rule_.wider_reach(grains.radius[i], as_vec3(grains.velocity + 3 * i), gone);
      if (++left_ > most_wider || !(wider > 1.1 * gone)) return Answer::lists_end;
      set_reach(i, wider);
      answer = Answer::some_are_wider;
    }
    spare_ = std::min(spare_, reach_[i] - gone);
  }
  return answer;
}

}  // namespace encased_column
