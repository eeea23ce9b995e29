// SPDX-License-Identifier: GPL-2.0-only
// Surrogates: what each must know, and how they are compared.
#include "space/designs.h"
#include "stages/analysis.h"
#include "surrogate/cross_validation.h"
#include "surrogate/kriging.h"
#include "surrogate/network.h"
#include "surrogate/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace encased_column;

namespace {

Data data_of(int points, const std::function<double(const Eigen::VectorXd&)>& function,
             double noise = 0.0)
{
  std::mt19937 random(4);
  Data data{space_filling_design(DesignKind::sobol, points, 2, 3), Eigen::VectorXd(points), {}};
  for (int n = 0; n < points; ++n) {
    const double share = static_cast<double>(random()) / 4294967296.0;
    data.values[n] = function(data.points.row(n).transpose()) + noise * (2.0 * share - 1.0);
    data.groups.push_back(n);
  }
  return data;
}

double saddle(const Eigen::VectorXd& x)
{
  return 1e6 * (3.0 + x[0] * x[0] - 2.0 * x[0] * x[1]);
}

double wave(const Eigen::VectorXd& x)
{
  return std::sin(7.0 * x[0]) + std::cos(5.0 * x[1]);
}

const Eigen::Vector2d somewhere(0.37, 0.81);

}  // namespace

TEST(Polynomial, FindsAPolynomialAgainWithItsTermsOnly)
{
  const Polynomial found = fit_polynomial(data_of(40, saddle));
  EXPECT_NEAR(found.value(somewhere), saddle(somewhere), 1e-6 * 1e6);
  // 1, P1(x), P2(x), P1(y), P1(x) P1(y)
  double elsewhere = 0.0;
  for (std::size_t k = 0; k < found.degrees().size(); ++k)
    if (found.degrees()[k][0] + found.degrees()[k][1] > 2)
      elsewhere += std::abs(found.coefficients()[static_cast<Eigen::Index>(k)]);
  EXPECT_LT(elsewhere, 1e-3);
}

// Of orthonormal terms the squares of all but the constant add up to the variance: of x^2 it is
// 4/45.
TEST(Polynomial, HasOrthonormalTerms)
{
  const Polynomial found =
      fit_polynomial(data_of(30, [](const Eigen::VectorXd& x) { return x[0] * x[0]; }));
  EXPECT_NEAR(found.coefficients()[0], 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(found.coefficients().tail(found.coefficients().size() - 1).squaredNorm(), 4.0 / 45.0,
              1e-9);
}

TEST(Polynomial, IsAConstantWhereNothingVaries)
{
  const Polynomial found = fit_polynomial(data_of(12, [](const Eigen::VectorXd&) { return 7.0; }));
  EXPECT_EQ(found.degrees().size(), 1u);
  EXPECT_DOUBLE_EQ(found.value(somewhere), 7.0);
}

TEST(Network, LearnsACurvedSurface)
{
  const Data data = data_of(120, saddle);
  const auto network = fit_network(data, 1);
  EXPECT_NEAR(network->value(somewhere), saddle(somewhere), 0.03e6);
  EXPECT_EQ(network->value(somewhere), fit_network(data, 1)->value(somewhere));
}

// The equations of universal Kriging, solved here in another way: minimise the variance of a
// weighted mean of the values under the condition that it is right for every plane.
TEST(Kriging, IsTheBestUnbiasedWeightedMean)
{
  const Data data = data_of(25, wave);
  const KrigingShape shape{Eigen::Vector2d(0.4, 0.6), 1.3, 1e-2};
  const auto correlation = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    const double s = std::sqrt(5.0) * (a - b).cwiseQuotient(shape.reach).norm();
    return (1.0 + s + s * s / 3.0) * std::exp(-s);
  };
  const Eigen::Index n = data.size();
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n + 3, n + 3);
  Eigen::VectorXd right(n + 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j)
      left(i, j) =
          correlation(data.points.row(i), data.points.row(j)) + (i == j ? shape.nugget : 0);
    left.block(i, n, 1, 3) << 1.0, data.points(i, 0), data.points(i, 1);
    right[i] = correlation(somewhere, data.points.row(i));
  }
  left.block(n, 0, 3, n) = left.block(0, n, n, 3).transpose();
  right.tail(3) << 1.0, somewhere[0], somewhere[1];
  const double best = left.fullPivLu().solve(right).head(n).dot(data.values);
  EXPECT_NEAR(fit_kriging(data, shape)->value(somewhere), best, 1e-6);
}

TEST(Kriging, TakesMoreOfItsValuesForNoiseWhereThereIsMore)
{
  const KrigingShape clean = kriging_shape(data_of(40, wave));
  const KrigingShape noisy = kriging_shape(data_of(40, wave, 0.8));
  EXPECT_LE(clean.nugget, 1e-4);
  EXPECT_GE(noisy.nugget, 1e-2);
}

TEST(CrossValidation, LeavesRunsOfOnePointOutTogether)
{
  const std::vector<int> groups{0, 0, 0, 1, 2, 3, 3, 4, 5, 6};
  std::vector<int> seen(groups.size(), 0);
  for (const Fold& fold : folds_of(groups, 4, 1)) {
    for (const Eigen::Index row : fold.left_out) {
      ++seen[static_cast<std::size_t>(row)];
      for (const Eigen::Index other : fold.learnt)
        EXPECT_NE(groups[static_cast<std::size_t>(row)], groups[static_cast<std::size_t>(other)]);
    }
    EXPECT_EQ(fold.left_out.size() + fold.learnt.size(), groups.size());
  }
  EXPECT_EQ(seen, std::vector<int>(groups.size(), 1));
}

// E* a and kappa b as powers, exp(6 x - 2 y): straight in its logarithm, where three terms tell
// all.
TEST(Surrogates, LearnWhatScattersInProportionByItsLogarithm)
{
  const auto power = [](const Eigen::VectorXd& x) {
    return 1e6 * std::exp(6.0 * x[0] - 2.0 * x[1]);
  };
  Data data = data_of(12, power);
  const auto off = [&](const SurrogateKind kind) {
    return std::abs(fit_of(kind, data, 1)(data)->value(somewhere) / power(somewhere) - 1.0);
  };
  EXPECT_GT(off(SurrogateKind::polynomial), 0.02);
  data.proportional = true;
  EXPECT_LT(off(SurrogateKind::polynomial), 1e-9);
  EXPECT_LT(off(SurrogateKind::kriging), 0.05);
  EXPECT_LT(cross_validate(SurrogateKind::polynomial, data, 4, 1).error, 1e-3);
}

// Two points with two packings each, 20 % apart: the logarithms differ by ln 1.2 at both.
TEST(Surrogates, ScatterOfPackingsGoesWithTheValueWhereItIsInProportion)
{
  Data data{Eigen::MatrixXd::Zero(4, 1), Eigen::Vector4d(10.0, 12.0, 100.0, 120.0), {0, 0, 1, 1}};
  EXPECT_NEAR(packing_scatter(data, 50.0), std::sqrt(0.5 * (2.0 + 200.0)), 1e-12);
  data.proportional = true;
  EXPECT_NEAR(packing_scatter(data, 50.0), 50.0 * std::log(1.2) / std::sqrt(2.0), 1e-12);
}

// Noise that no surrogate can foretell: its error is that of the noise, 0.5 / sqrt(3) = 0.289, or a
// little more, and not the smaller one of values it has learnt.
TEST(CrossValidation, FindsTheErrorOfRunsThatWereNotLearnt)
{
  const Data data = data_of(
      60, [](const Eigen::VectorXd& x) { return 4.0 * x[0]; }, 0.5);
  const Validation found = cross_validate(SurrogateKind::polynomial, data, 10, 1);
  EXPECT_GT(found.error, 0.25);
  EXPECT_LT(found.error, 0.42);
  const double variance = (data.values.array() - data.values.mean()).square().mean();
  EXPECT_DOUBLE_EQ(found.score, 1.0 - found.error * found.error / variance);
}

TEST(CrossValidation, ForetellsARunWithoutItsOwnValue)
{
  Data data = data_of(30, wave);
  const double foretold = cross_validate(SurrogateKind::polynomial, data, 30, 1).foretold[7];
  data.values[7] += 10.0;
  EXPECT_EQ(cross_validate(SurrogateKind::polynomial, data, 30, 1).foretold[7], foretold);
}

TEST(CrossValidation, PrefersTheSurrogateThatForetellsBetter)
{
  const Data data =
      data_of(40, [](const Eigen::VectorXd& x) { return std::abs(x[0] - 0.5) + wave(x); });
  std::vector<Validation> all;
  for (const SurrogateKind kind :
       {SurrogateKind::polynomial, SurrogateKind::network, SurrogateKind::kriging})
    all.push_back(cross_validate(kind, data, 5, 1));
  for (const Validation& one : all) EXPECT_GE(one.error, better_of(all).error);
  EXPECT_GT(better_of(all).score, 0.9);
}

TEST(CrossValidation, LooksAtTheErrorNearAValue)
{
  Data data = data_of(60, [](const Eigen::VectorXd& x) { return x[0]; });
  Validation made{SurrogateKind::polynomial, data.values, 0.0, 0.0};
  for (Eigen::Index n = 0; n < data.size(); ++n)
    if (data.values[n] > 0.5) data.values[n] += 0.1;
  EXPECT_DOUBLE_EQ(error_near(made, data, 0.0), 0.0);
  EXPECT_NEAR(error_near(made, data, 1.0), 0.1, 1e-12);
}
