// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cstddef>
#include <vector>

namespace encased_column {

/// Whether a test whose last sample is at `end` counts as having come to `wanted`: what it lacks to
/// it, half a percent at most, is the rest of a step between samples.
inline bool got_to(double end, double wanted)
{
  return end >= 0.995 * wanted;
}

/// A quantity y sampled along x (for a test: along axial strain) and taken as linear between the
/// samples, so that averages do not depend on how densely a stretch was sampled.
class SampledCurve {
 public:
  /// Throws InputError unless both have the same length, two samples at least, and x never falls
  /// and rises in all.
  SampledCurve(std::vector<double> x, std::vector<double> y);

  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  std::size_t size() const { return x_.size(); }

  /// y at `x`; outside the samples the value of the nearest one.
  double value(double x) const;

  /// Mean of y over the part of [low, high] that was sampled, by the exact integral of the
  /// polygon. Requires low < last x and high > first x.
  double mean(double low, double high) const;

  /// Mean over `width` centred on each sample; next to the ends over the part that was sampled.
  std::vector<double> moving_average(double width) const;

  /// Means over consecutive windows of `width` from the first sample on; the last window ends at
  /// the last sample and may share a part with the one before. One window if x spans less.
  std::vector<double> window_means(double width) const;

 private:
  double integral_to(double x) const;

  std::vector<double> x_, y_;
  std::vector<double> integral_;  ///< of y from the first sample to each
};

}  // namespace encased_column
