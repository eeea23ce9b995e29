#include "runner/schedule.h"

#include <algorithm>

namespace encased_column {

Schedule best_schedule(int cases, int cores, int ranks, int jobs)
{
  constexpr double speed[] = {1.0, 1.85, 2.6, 3.3};
  if (ranks == 0) {
    double shortest = 0.0;
    for (int r = 1; r <= 4 && r <= std::max(cores, 1); ++r) {
      const int at_once = std::max(cores / r, 1);
      const double time = (cases + at_once - 1) / at_once / speed[r - 1];
      if (r > 1 && time >= shortest) continue;
      shortest = time;
      ranks = r;
    }
  }
  if (jobs == 0) jobs = std::max(cores / ranks, 1);
  return {ranks, jobs};
}

}  // namespace encased_column
