// SPDX-License-Identifier: GPL-2.0-only
#include "runner/time_left.h"

#include <algorithm>
#include <numeric>

namespace encased_column {

namespace {

/// When each of several places is free again; a case takes the first one.
class FreePlaces {
 public:
  explicit FreePlaces(int number) : free_at_(static_cast<std::size_t>(std::max(number, 1)), 0.0) {}

  void take(double seconds) { *std::min_element(free_at_.begin(), free_at_.end()) += seconds; }
  double last() const { return *std::max_element(free_at_.begin(), free_at_.end()); }

 private:
  std::vector<double> free_at_;
};

}  // namespace

std::optional<double> seconds_left(const std::vector<CaseClock>& clocks, int jobs)
{
  double seconds = 0.0, done = 0.0, all = 0.0;
  for (const CaseClock& clock : clocks) {
    all += clock.work;
    if (!clock.begun) continue;
    seconds += clock.seconds;
    done += clock.work * (clock.fraction - clock.brought);
  }
  // Before that a start alone decides.
  if (!(done > 0.005 * all)) return std::nullopt;
  const double rate = seconds / done;
  FreePlaces places(jobs);
  for (const bool begun : {true, false})
    for (const CaseClock& clock : clocks)
      if (!clock.ended && clock.begun == begun)
        places.take(rate * clock.work * (1.0 - (begun ? clock.fraction : clock.brought)));
  return places.last();
}

std::vector<std::size_t> largest_first(const std::vector<double>& work)
{
  std::vector<std::size_t> places(work.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  return places;
}

double seconds_of_all(const std::vector<double>& work, double rate, int jobs)
{
  FreePlaces places(jobs);
  for (const double one : work) places.take(rate * one);
  return places.last();
}

}  // namespace encased_column
