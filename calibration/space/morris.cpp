// SPDX-License-Identifier: GPL-2.0-only
#include "space/morris.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace encased_column {

namespace {

/// Whole number below `limit`, the same on every machine (std's distributions are not).
int draw(std::mt19937& random, int limit)
{
  return static_cast<int>(random() % static_cast<unsigned>(limit));
}

MorrisEffect statistics(const std::vector<double>& effects)
{
  MorrisEffect result;
  result.effects = static_cast<int>(effects.size());
  if (effects.empty()) return result;
  const double count = static_cast<double>(effects.size());
  for (const double effect : effects) {
    result.mean += effect / count;
    result.mean_size += std::abs(effect) / count;
  }
  if (effects.size() < 2) return result;
  double about_mean = 0.0, about_size = 0.0;
  for (const double effect : effects) {
    about_mean += std::pow(effect - result.mean, 2);
    about_size += std::pow(std::abs(effect) - result.mean_size, 2);
  }
  result.deviation = std::sqrt(about_mean / (count - 1.0));
  result.standard_error = std::sqrt(about_size / (count - 1.0) / count);
  return result;
}

}  // namespace

MorrisPlan morris_plan(int ways, int dimensions, int levels, unsigned seed)
{
  std::mt19937 random(seed);
  const double step = 0.5 * levels / (levels - 1.0);
  MorrisPlan plan{Eigen::MatrixXd(ways * (dimensions + 1), dimensions), {}, step};
  for (int way = 0; way < ways; ++way) {
    // From the lower half of the levels a parameter goes up, from the upper half down.
    Eigen::RowVectorXd point(dimensions);
    for (int i = 0; i < dimensions; ++i) point[i] = draw(random, levels) / (levels - 1.0);
    std::vector<int> order(static_cast<std::size_t>(dimensions));
    std::iota(order.begin(), order.end(), 0);
    for (int i = dimensions - 1; i > 0; --i)
      std::swap(order[static_cast<std::size_t>(i)],
                order[static_cast<std::size_t>(draw(random, i + 1))]);
    int row = way * (dimensions + 1);
    plan.points.row(row) = point;
    for (const int i : order) {
      point[i] += point[i] < 0.5 ? step : -step;
      plan.points.row(++row) = point;
      plan.changed.push_back(i);
    }
  }
  return plan;
}

std::vector<MorrisEffect> morris_effects(const MorrisPlan& plan, const Eigen::VectorXd& values)
{
  const auto dimensions = static_cast<std::size_t>(plan.points.cols());
  std::vector<std::vector<double>> effects(dimensions);
  for (std::size_t n = 0; n < plan.changed.size(); ++n) {
    const auto before = static_cast<Eigen::Index>(n + n / dimensions);
    const int i = plan.changed[n];
    const double change = plan.points(before + 1, i) - plan.points(before, i);
    const double effect = (values[before + 1] - values[before]) / change;
    if (std::isfinite(effect)) effects[static_cast<std::size_t>(i)].push_back(effect);
  }
  std::vector<MorrisEffect> results;
  for (const std::vector<double>& one : effects) results.push_back(statistics(one));
  return results;
}

}  // namespace encased_column
