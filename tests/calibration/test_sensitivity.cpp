// SPDX-License-Identifier: GPL-2.0-only
// Sensitivity against closed forms.
#include "space/designs.h"
#include "space/morris.h"
#include "surrogate/sobol_indices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace encased_column;

namespace {

Data sampled(int points, int dimensions, double (*function)(const Eigen::VectorXd&))
{
  Data data{
      space_filling_design(DesignKind::sobol, points, dimensions, 1), Eigen::VectorXd(points), {}};
  for (int n = 0; n < points; ++n) {
    data.values[n] = function(data.points.row(n).transpose());
    data.groups.push_back(n);
  }
  return data;
}

/// T. Ishigami, T. Homma (1990), with a = 7 and b = 0.1, on the unit cube.
double ishigami(const Eigen::VectorXd& point)
{
  const Eigen::VectorXd x = M_PI * (2.0 * point.array() - 1.0);
  return std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2) +
         0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

}  // namespace

// V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2, V1 = (1 + b pi^4/5)^2 / 2, V2 = a^2/8,
// V13 = b^2 pi^8 (1/18 - 1/50).
TEST(SobolIndices, OfIshigamisFunctionAreThoseOfTheClosedFormWithinTheirErrors)
{
  const double a = 7.0, b = 0.1, p4 = std::pow(M_PI, 4), p8 = p4 * p4;
  const double v = a * a / 8.0 + b * p4 / 5.0 + b * b * p8 / 18.0 + 0.5;
  const double v1 = 0.5 * std::pow(1.0 + b * p4 / 5.0, 2), v2 = a * a / 8.0,
               v13 = b * b * p8 * (1.0 / 18.0 - 1.0 / 50.0);
  EXPECT_NEAR(v1 / v, 0.3139, 1e-4);
  EXPECT_NEAR(v2 / v, 0.4424, 1e-4);
  EXPECT_NEAR(v13 / v, 0.2437, 1e-4);
  const Data data = sampled(256, 3, ishigami);
  const SobolIndices found = sobol_indices(fit_polynomial(data), data, 50, 1);
  const double first[] = {v1 / v, v2 / v, 0.0}, total[] = {(v1 + v13) / v, v2 / v, v13 / v};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.first[i].value, first[i], found.first[i].error) << i;
    EXPECT_NEAR(found.total[i].value, total[i], found.total[i].error) << i;
    EXPECT_LT(found.first[i].error, 2e-3) << i;
    EXPECT_LT(found.total[i].error, 2e-3) << i;
  }
}

// Of 3 x + y the variances of the parts are as 9 to 1.
TEST(SobolIndices, OfAPlaneAreTheSquaresOfItsSlopes)
{
  const Data data =
      sampled(40, 3, [](const Eigen::VectorXd& x) { return 3.0 * x[0] + x[1] - 2.0; });
  const SobolIndices found = sobol_indices(fit_polynomial(data), data, 20, 1);
  EXPECT_NEAR(found.first[0].value, 0.9, 1e-9);
  EXPECT_NEAR(found.total[1].value, 0.1, 1e-9);
  EXPECT_NEAR(found.total[2].value, 0.0, 1e-9);
}

// A fifth of the variance is noise that no parameter brings about: it must stand in the errors.
TEST(SobolIndices, CountWhatIsNotExplainedAsTheirError)
{
  Data data = sampled(200, 2, [](const Eigen::VectorXd& x) { return x[0]; });
  std::mt19937 random(5);
  for (double& value : data.values) value += (random() % 2 ? 1.0 : -1.0) * 0.144;
  const SobolIndices found = sobol_indices(fit_polynomial(data), data, 20, 1);
  EXPECT_NEAR(found.unexplained, 0.2, 0.05);
  EXPECT_GT(found.first[1].error, 0.15);
}

TEST(Morris, EffectsOfAPlaneAreItsSlopesWithoutScatter)
{
  const MorrisPlan plan = morris_plan(5, 3, 4, 7);
  ASSERT_EQ(plan.points.rows(), 20);
  EXPECT_GE(plan.points.minCoeff(), -1e-12);
  EXPECT_LE(plan.points.maxCoeff(), 1.0 + 1e-12);
  Eigen::VectorXd values(20);
  for (int n = 0; n < 20; ++n) values[n] = 2.0 * plan.points(n, 0) - 5.0 * plan.points(n, 1) + 1.0;
  const auto effects = morris_effects(plan, values);
  EXPECT_NEAR(effects[0].mean, 2.0, 1e-12);
  EXPECT_NEAR(effects[1].mean, -5.0, 1e-12);
  EXPECT_NEAR(effects[1].mean_size, 5.0, 1e-12);
  EXPECT_NEAR(effects[2].mean_size, 0.0, 1e-12);
  EXPECT_NEAR(effects[1].deviation, 0.0, 1e-12);
  EXPECT_NEAR(effects[1].standard_error, 0.0, 1e-12);
}

// The effect of x on x y is y, whose levels 0, 1/3, 2/3, 1 have the mean 1/2 and the standard
// deviation sqrt(5) / 6.
TEST(Morris, DeviationTellsAnInteraction)
{
  const MorrisPlan plan = morris_plan(400, 2, 4, 3);
  Eigen::VectorXd values(plan.points.rows());
  for (Eigen::Index n = 0; n < values.size(); ++n)
    values[n] = plan.points(n, 0) * plan.points(n, 1);
  const auto effects = morris_effects(plan, values);
  EXPECT_NEAR(effects[0].mean, 0.5, 0.06);
  EXPECT_NEAR(effects[0].deviation, std::sqrt(5.0) / 6.0, 0.03);
  EXPECT_NEAR(effects[0].standard_error, effects[0].deviation / 20.0, 1e-3);
}

TEST(Morris, LeavesTheEffectsOfFailedRunsOut)
{
  const MorrisPlan plan = morris_plan(3, 2, 4, 1);
  Eigen::VectorXd values = plan.points.col(0);
  values[1] = NAN;  // the middle of the first way: both its effects
  const auto effects = morris_effects(plan, values);
  EXPECT_EQ(effects[0].effects, 2);
  EXPECT_EQ(effects[1].effects, 2);
  EXPECT_NEAR(effects[0].mean, 1.0, 1e-12);
}

TEST(Designs, FillTheCubeAndAreTheSameForTheSameSeed)
{
  for (const DesignKind kind : {DesignKind::sobol, DesignKind::latin_hypercube}) {
    const Eigen::MatrixXd design = space_filling_design(kind, 32, 3, 5);
    EXPECT_EQ(design, space_filling_design(kind, 32, 3, 5));
    EXPECT_NE(design, space_filling_design(kind, 32, 3, 6));
    for (Eigen::Index i = 0; i < 3; ++i) {
      EXPECT_NEAR(design.col(i).mean(), 0.5, 0.05);
      for (int eighth = 0; eighth < 8; ++eighth)
        EXPECT_NEAR((design.col(i).array() * 8.0).floor().cwiseEqual(eighth).count(), 4, 3);
    }
  }
}
