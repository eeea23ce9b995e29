// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace encased_column {

std::vector<Fold> folds_of(const std::vector<int>& groups, int count, unsigned seed)
{
  const std::set<int> different(groups.begin(), groups.end());
  std::vector<int> order(different.begin(), different.end());
  std::mt19937 random(seed);
  for (std::size_t n = order.size(); n > 1; --n) std::swap(order[n - 1], order[random() % n]);
  const std::size_t folds = std::min(static_cast<std::size_t>(count), order.size());
  std::vector<Fold> result(folds);
  for (std::size_t row = 0; row < groups.size(); ++row) {
    const auto place = static_cast<std::size_t>(std::find(order.begin(), order.end(), groups[row]) -
                                                order.begin());
    for (std::size_t fold = 0; fold < folds; ++fold)
      (place % folds == fold ? result[fold].left_out : result[fold].learnt)
          .push_back(static_cast<Eigen::Index>(row));
  }
  return result;
}

Validation cross_validate(SurrogateKind kind, const Data& data, int folds, unsigned seed)
{
  Validation result{kind, Eigen::VectorXd(data.size()), 0.0, 0.0};
  const Fit fit = fit_of(kind, data, seed);
  for (const Fold& fold : folds_of(data.groups, folds, seed)) {
    const auto surrogate = fit(data.rows(fold.learnt));
    for (const Eigen::Index row : fold.left_out)
      result.foretold[row] = surrogate->value(data.points.row(row).transpose());
  }
  const double square =
      (result.foretold - data.values).squaredNorm() / static_cast<double>(data.size());
  const double variance = (data.values.array() - data.values.mean()).square().mean();
  result.error = std::sqrt(square);
  result.score = variance > 0.0 ? 1.0 - square / variance : 1.0;
  return result;
}

const Validation& better_of(const std::vector<Validation>& all)
{
  return *std::min_element(all.begin(), all.end(), [](const Validation& a, const Validation& b) {
    return a.error < b.error;
  });
}

double error_near(const Validation& validation, const Data& data, double value)
{
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(data.size()));
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_sort(rows.begin(), rows.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::abs(validation.foretold[a] - value) < std::abs(validation.foretold[b] - value);
  });
  rows.resize(std::min(rows.size(), std::max<std::size_t>(10, rows.size() / 3)));
  double square = 0.0;
  for (const Eigen::Index row : rows)
    square += std::pow(validation.foretold[row] - data.values[row], 2);
  return std::sqrt(square / static_cast<double>(rows.size()));
}

}  // namespace encased_column
