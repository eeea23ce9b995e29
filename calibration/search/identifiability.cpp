// SPDX-License-Identifier: GPL-2.0-only
#include "search/identifiability.h"

#include <cmath>
#include <cstdio>

namespace encased_column {

namespace {

constexpr double spread_of_range =
    0.288675;  // standard deviation of a uniform column, 1 / sqrt(12)
constexpr double told_below = 0.35, not_told_from = 0.7;
constexpr double together_from = 0.8;               // correlation
constexpr double edge = 0.05, at_edge_from = 0.25;  // of the range, of the points

double deviation_of(const Eigen::VectorXd& column)
{
  return std::sqrt((column.array() - column.mean()).square().mean());
}

std::string percent(double share)
{
  return std::to_string(std::lround(100.0 * share)) + " %";
}

std::string pair_sentence(const std::string& a, const std::string& b, double correlation)
{
  char number[16];
  std::snprintf(number, sizeof number, "%.2f", correlation);
  return "Of " + a + " and " + b + " the data tell a combination, not each (correlation " + number +
         "): where one is larger, the other " +
         (correlation > 0.0 ? "is larger too" : "is smaller") + ".";
}

}  // namespace

Knowledge knowledge_of(const Eigen::VectorXd& column)
{
  const double left = deviation_of(column) / spread_of_range;
  if (left <= told_below) return Knowledge::told;
  return left < not_told_from ? Knowledge::partly : Knowledge::not_told;
}

std::vector<std::string> what_is_not_told(const Posterior& posterior,
                                          const std::vector<std::string>& names)
{
  std::vector<std::string> sentences;
  const Eigen::MatrixXd& points = posterior.points;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Eigen::VectorXd column = points.col(static_cast<Eigen::Index>(i));
    const double left = deviation_of(column) / spread_of_range;
    if (knowledge_of(column) == Knowledge::not_told)
      sentences.push_back("The data do not tell " + names[i] +
                          ": its interval is about as wide as " + "its range (" + percent(left) +
                          " of the spread is left).");
    else if (knowledge_of(column) == Knowledge::partly)
      sentences.push_back("The data tell " + names[i] + " only roughly (" + percent(left) +
                          " of the spread is left).");
    if (knowledge_of(column) == Knowledge::not_told) continue;
    const double rows = static_cast<double>(column.size());
    const double low = static_cast<double>((column.array() < edge).count()) / rows;
    const double high = static_cast<double>((column.array() > 1.0 - edge).count()) / rows;
    if (std::max(low, high) >= at_edge_from)
      sentences.push_back("The " + std::string(low > high ? "lower" : "upper") +
                          " end of the range of " + names[i] + " cuts its interval (" +
                          percent(std::max(low, high)) + " of it lies there): widen the range.");
  }
  const Eigen::MatrixXd together = correlations(points);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      const double one = together(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(one) >= together_from)
        sentences.push_back(pair_sentence(names[i], names[j], one));
    }
  return sentences;
}

}  // namespace encased_column
