#pragma once

#include <limits>

namespace encased_column {

/// Heights [m] between which something counts; by default all of them.
struct HeightWindow {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  double height() const { return high - low; }
  /// Level [m] at the part `part` [-] of the height, from below.
  double level(double part) const { return low + part * height(); }
  bool holds(double z) const { return z > low && z < high; }
  /// The third half way up: away from what the platens do to the stress.
  HeightWindow middle_third() const
  {
    const double third = height() / 3.0;
    return {low + third, high - third};
  }
  /// Level [m] of the center of sphere n of `count` that stand one above the other, from one that
  /// touches the lower end to one that touches the upper; a single one stands half way up.
  double level_in_stack(int n, int count, double radius) const
  {
    const double part = count > 1 ? static_cast<double>(n) / (count - 1) : 0.5;
    return HeightWindow{low + radius, high - radius}.level(part);
  }
};

}  // namespace encased_column
