// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cmath>
#include <initializer_list>

namespace encased_column {

/// The smallest step of 1, 2 or 5 times a power of ten that divides `span` > 0 into `most` parts
/// at most, so that axes and colour bars are labelled with round numbers.
inline double round_step(double span, int most)
{
  const double power = std::pow(10.0, std::floor(std::log10(span / most)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (span <= factor * power * most * (1.0 + 1e-9)) return factor * power;
  return 10.0 * power;
}

/// From `low` to `high` in whole steps.
struct RoundRange {
  double low, high;
};

/// The range around [`low`, `high`], high > low, in whole steps from a multiple of the step on, so
/// that round_step() of its own span divides it without a rest.
inline RoundRange round_range(double low, double high, int most)
{
  RoundRange range{low, high};
  for (double step = 0.0; step < round_step(range.high - range.low, most);) {
    step = round_step(range.high - range.low, most);
    range = {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
  }
  return range;
}

}  // namespace encased_column
