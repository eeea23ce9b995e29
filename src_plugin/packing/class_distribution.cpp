// SPDX-License-Identifier: GPL-2.0-only
#include "packing/class_distribution.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

ClassDistribution class_distribution(const std::string& word)
{
  if (word == "log_uniform") return ClassDistribution::log_uniform;
  if (word == "uniform") return ClassDistribution::uniform;
  if (word == "uniform_number") return ClassDistribution::uniform_number;
  throw InputError("'distribution' must be one of: log_uniform, uniform, uniform_number; found '" +
                   word + "', write for example 'distribution log_uniform'");
}

double number_exponent(ClassDistribution distribution)
{
  switch (distribution) {
    case ClassDistribution::log_uniform:
      return -4.0;
    case ClassDistribution::uniform:
      return -3.0;
    case ClassDistribution::uniform_number:
      break;
  }
  return 0.0;
}

double power_integral(double m, double a, double b)
{
  if (m == -1.0) return std::log(b / a);
  return (std::pow(b, m + 1.0) - std::pow(a, m + 1.0)) / (m + 1.0);
}

double power_quantile(double m, double a, double b, double f)
{
  if (m == -1.0) return a * std::pow(b / a, f);
  const double low = std::pow(a, m + 1.0);
  const double high = std::pow(b, m + 1.0);
  return std::clamp(std::pow(low + f * (high - low), 1.0 / (m + 1.0)), a, b);
}

}  // namespace encased_column
