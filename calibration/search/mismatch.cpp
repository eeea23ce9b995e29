// SPDX-License-Identifier: GPL-2.0-only
#include "search/mismatch.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace encased_column {

double combined_deviation(double tolerance, double packing_scatter, double surrogate_error)
{
  return std::hypot(tolerance * deviation_of_interval, std::max(packing_scatter, surrogate_error));
}

double mismatch(const Eigen::VectorXd& values, const std::vector<Goal>& goals)
{
  constexpr double missing = 10.0;  // deviations
  double sum = 0.0;
  for (std::size_t n = 0; n < goals.size(); ++n) {
    const Goal& goal = goals[n];
    if (goal.weight == 0.0) continue;
    const double off = (values[static_cast<Eigen::Index>(n)] - goal.value) / goal.deviation;
    sum += goal.weight * (std::isfinite(off) ? off * off : missing * missing);
  }
  return sum;
}

bool all_met(const Eigen::VectorXd& values, const std::vector<Goal>& goals)
{
  for (std::size_t n = 0; n < goals.size(); ++n)
    if (goals[n].weight > 0.0 &&
        !(std::abs(values[static_cast<Eigen::Index>(n)] - goals[n].value) <= goals[n].tolerance))
      return false;
  return true;
}

double pooled_scatter(const Eigen::VectorXd& values, const std::vector<int>& groups)
{
  std::map<int, std::vector<double>> runs;
  for (std::size_t n = 0; n < groups.size(); ++n)
    if (std::isfinite(values[static_cast<Eigen::Index>(n)]))
      runs[groups[n]].push_back(values[static_cast<Eigen::Index>(n)]);
  double square = 0.0, freedom = 0.0;
  for (const auto& [group, found] : runs) {
    double mean = 0.0;
    for (const double one : found) mean += one / static_cast<double>(found.size());
    for (const double one : found) square += (one - mean) * (one - mean);
    freedom += static_cast<double>(found.size()) - 1.0;
  }
  return freedom > 0.0 ? std::sqrt(square / freedom) : 0.0;
}

}  // namespace encased_column
