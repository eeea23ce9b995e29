// SPDX-License-Identifier: GPL-2.0-only
#include "space/parameter_space.h"

#include <cmath>

namespace encased_column {

double ParameterSpace::value(int i, double share) const
{
  const Parameter& one = (*this)[i];
  if (one.logarithmic) return one.low * std::pow(one.high / one.low, share);
  return one.low + share * (one.high - one.low);
}

double ParameterSpace::share(int i, double value) const
{
  const Parameter& one = (*this)[i];
  if (one.logarithmic) return std::log(value / one.low) / std::log(one.high / one.low);
  return (value - one.low) / (one.high - one.low);
}

std::vector<double> ParameterSpace::values(const Eigen::VectorXd& point) const
{
  std::vector<double> all;
  for (int i = 0; i < size(); ++i) all.push_back(value(i, point[i]));
  return all;
}

}  // namespace encased_column
