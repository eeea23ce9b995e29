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

}  // namespace encased_column
