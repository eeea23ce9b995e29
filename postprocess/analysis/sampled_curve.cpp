// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/sampled_curve.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace encased_column {

SampledCurve::SampledCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)),
      y_(std::move(y)),
      integral_(x_.size(), 0.0)
{
  if (x_.size() != y_.size() || x_.size() < 2)
    throw InputError("a curve takes two samples at least, found " + std::to_string(x_.size()) +
                     ", let the test run on");
  for (std::size_t i = 1; i < x_.size(); ++i) {
    if (x_[i] < x_[i - 1])
      throw InputError("axial strain must not fall from row to row, found " + in_words(x_[i]) +
                       " after " + in_words(x_[i - 1]) + " in row " + std::to_string(i + 1) +
                       ", remove the rows that a restart wrote twice");
    integral_[i] = integral_[i - 1] + 0.5 * (y_[i] + y_[i - 1]) * (x_[i] - x_[i - 1]);
  }
  if (x_.back() <= x_.front())
    throw InputError("axial strain must rise through a test, found " + in_words(x_.front()) +
                     " in all rows, let the test run on");
}

double SampledCurve::value(double x) const
{
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin();
  const double part = (x - x_[i - 1]) / (x_[i] - x_[i - 1]);
  return y_[i - 1] + part * (y_[i] - y_[i - 1]);
}

double SampledCurve::integral_to(double x) const
{
  if (x <= x_.front()) return 0.0;
  if (x >= x_.back()) return integral_.back();
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin();
  return integral_[i - 1] + 0.5 * (y_[i - 1] + value(x)) * (x - x_[i - 1]);
}

double SampledCurve::mean(double low, double high) const
{
  low = std::max(low, x_.front());
  high = std::min(high, x_.back());
  return (integral_to(high) - integral_to(low)) / (high - low);
}

std::vector<double> SampledCurve::moving_average(double width) const
{
  std::vector<double> average;
  average.reserve(size());
  for (const double x : x_) average.push_back(mean(x - 0.5 * width, x + 0.5 * width));
  return average;
}

std::vector<double> SampledCurve::window_means(double width) const
{
  const double span = x_.back() - x_.front();
  const auto windows = static_cast<std::size_t>(std::ceil(span / width - 1e-9));
  std::vector<double> means;
  for (std::size_t i = 0; i < windows; ++i) {
    const double high = std::min(x_.front() + (i + 1) * width, x_.back());
    means.push_back(mean(high - width, high));
  }
  return means;
}

}  // namespace encased_column
