// SPDX-License-Identifier: GPL-2.0-only
// Mismatch, search, posterior, and what the data do not tell.
#include "search/genetic_search.h"
#include "search/identifiability.h"
#include "search/mismatch.h"
#include "search/posterior.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;

TEST(Mismatch, IsTheWeightedSumOfSquaresOverDeviations)
{
  const std::vector<Goal> goals{
      {"a", 10.0, 1.0, 1.0, 2.0}, {"b", 5.0, 1.0, 0.5, 1.0}, {"foretold", 1.0, 1.0, 0.0, 1.0}};
  EXPECT_DOUBLE_EQ(mismatch(Eigen::Vector3d(14.0, 2.0, 99.0), goals), 4.0 + 0.5 * 9.0);
  EXPECT_DOUBLE_EQ(mismatch(Eigen::Vector3d(10.0, NAN, 0.0), goals), 50.0);
}

TEST(Mismatch, IsMetWithinTheToleranceOfWhatIsFitted)
{
  const std::vector<Goal> goals{{"a", 10.0, 1.0, 1.0, 1.0}, {"foretold", 1.0, 0.1, 0.0, 1.0}};
  EXPECT_TRUE(all_met(Eigen::Vector2d(10.9, 50.0), goals));
  EXPECT_FALSE(all_met(Eigen::Vector2d(11.1, 1.0), goals));
  EXPECT_FALSE(all_met(Eigen::Vector2d(NAN, 1.0), goals));
}

// Points {1, 3} and {10, 10, 16}: squares 2 and 24 over 1 + 2 degrees of freedom.
TEST(Mismatch, PoolsTheScatterOfPackingsOverPoints)
{
  Eigen::VectorXd values(7);
  values << 1.0, 3.0, 10.0, 10.0, 16.0, 99.0, NAN;
  EXPECT_DOUBLE_EQ(pooled_scatter(values, {0, 0, 1, 1, 1, 2, 2}), std::sqrt(26.0 / 3.0));
  EXPECT_DOUBLE_EQ(pooled_scatter(values, {0, 1, 2, 3, 4, 5, 6}), 0.0);
}

TEST(Mismatch, TakesTheToleranceForA95PercentInterval)
{
  EXPECT_NEAR(combined_deviation(1.959964, 0.0, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(combined_deviation(1.959964, 0.5, 2.0), std::sqrt(5.0), 1e-6);
}

TEST(GeneticSearch, FindsTheLowestOfManyValleys)
{
  // 49 valleys, 1/7 apart; the lowest, at (0.5, 0.5), is the one next to (0.52, 0.52).
  const CubeFunction function = [](const Eigen::VectorXd& x) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 2; ++i)
      sum += std::cos(14.0 * M_PI * x[i]) + 4.0 * std::pow(x[i] - 0.52, 2);
    return sum;
  };
  const Found found = genetic_search(function, 2, 1);
  EXPECT_NEAR(found.point[0], 0.5, 0.01);
  EXPECT_NEAR(found.point[1], 0.5, 0.01);
  EXPECT_EQ(found.values[0], function(found.point));
}

// Near 0 against near 1: every point between is as good, none beside.
TEST(GeneticSearch, FindsTheFrontOfTwoObjectives)
{
  const auto front = pareto_search(
      [](const Eigen::VectorXd& x) { return x[0] * x[0] + x[1]; },
      [](const Eigen::VectorXd& x) { return (1.0 - x[0]) * (1.0 - x[0]) + x[1]; }, 2, 1);
  ASSERT_GE(front.size(), 15u);
  for (const Found& one : front) {
    EXPECT_LT(one.point[1], 1e-3);
    EXPECT_NEAR(std::sqrt(one.values[0]) + std::sqrt(one.values[1]), 1.0, 0.05);
  }
  EXPECT_LT(front.front().values[0], 0.05);
  EXPECT_LT(front.back().values[1], 0.05);
}

// A normal likelihood well inside the cube is its own posterior: mean, deviations and correlation.
TEST(Posterior, OfANormalLikelihoodIsThatNormalDistribution)
{
  Eigen::Matrix2d covariance;
  covariance << 0.0025, 0.0018, 0.0018, 0.0036;
  const Eigen::Matrix2d inverse = covariance.inverse();
  const Eigen::Vector2d mean(0.4, 0.6);
  const Posterior found = sample_posterior(
      [&](const Eigen::VectorXd& x) { return -0.5 * (x - mean).dot(inverse * (x - mean)); },
      Eigen::Vector2d(0.5, 0.5), 8000, 1);
  for (int i = 0; i < 2; ++i) {
    const double deviation = std::sqrt(covariance(i, i));
    EXPECT_NEAR(found.points.col(i).mean(), mean[i], 0.1 * deviation);
    EXPECT_NEAR(quantile(found.points.col(i), 0.975), mean[i] + 1.96 * deviation, 0.2 * deviation);
    EXPECT_NEAR(quantile(found.points.col(i), 0.025), mean[i] - 1.96 * deviation, 0.2 * deviation);
    EXPECT_LT(found.mixing[i], 1.05);
  }
  EXPECT_NEAR(correlations(found.points)(0, 1), 0.6, 0.06);
  EXPECT_GT(found.acceptance, 0.1);
  EXPECT_LT(found.acceptance, 0.6);
}

TEST(Posterior, StaysInTheCubeWhereTheDataTellNothing)
{
  const Posterior found = sample_posterior([](const Eigen::VectorXd&) { return 0.0; },
                                           Eigen::Vector2d(0.5, 0.5), 4000, 1);
  EXPECT_GE(found.points.minCoeff(), 0.0);
  EXPECT_LE(found.points.maxCoeff(), 1.0);
  EXPECT_NEAR(quantile(found.points.col(0), 0.025), 0.025, 0.03);
}

TEST(Identifiability, SaysWhichParametersTheDataLeaveOpen)
{
  Posterior posterior{Eigen::MatrixXd(1000, 4), 0.3, Eigen::VectorXd::Ones(4)};
  for (int n = 0; n < 1000; ++n) {
    const double open = (n + 0.5) / 1000.0, other = std::fmod(n * 0.618034, 1.0),
                 third = std::fmod(n * 0.414214, 1.0);
    posterior.points.row(n) << open, 0.5 + 0.1 * (other - 0.5), 0.02 * third,
        0.9 - 0.8 * open + 0.02 * other;
  }
  EXPECT_EQ(knowledge_of(posterior.points.col(0)), Knowledge::not_told);
  EXPECT_EQ(knowledge_of(posterior.points.col(1)), Knowledge::told);
  const auto sentences = what_is_not_told(posterior, {"open", "told", "edge", "tied"});
  const std::vector<std::string> expected{
      "The data do not tell open: its interval is about as wide as its range (100 % of the spread "
      "is "
      "left).",
      "The lower end of the range of edge cuts its interval (100 % of it lies there): widen the "
      "range.",
      "The data do not tell tied: its interval is about as wide as its range (80 % of the spread "
      "is "
      "left).",
      "Of open and tied the data tell a combination, not each (correlation -1.00): where one is "
      "larger, "
      "the other is smaller."};
  EXPECT_EQ(sentences, expected);
}
