// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "search/genetic_search.h"

#include <string>
#include <vector>

namespace encased_column {

/// What the data say of the parameters: points of the unit cube, one a row, as likely as they stand
/// there. Before the data all points of the cube were equally likely.
struct Posterior {
  Eigen::MatrixXd points;
  double acceptance;       ///< share of steps that were taken [-]
  Eigen::VectorXd mixing;  ///< Gelman and Rubin's R of each parameter: 1 where all chains agree
};

/// Random walks of Metropolis and Hastings, four of them from `start`, with steps shaped by the
/// covariance of a pilot walk; `samples` points in all. `log_likelihood` up to a constant. The same
/// for the same seed.
Posterior sample_posterior(const CubeFunction& log_likelihood, const Eigen::VectorXd& start,
                           int samples, unsigned seed);

/// Value below which the share `level` of a column lies.
double quantile(Eigen::VectorXd column, double level);

/// Correlations of the columns [-], 0 where one does not vary.
Eigen::MatrixXd correlations(const Eigen::MatrixXd& points);

}  // namespace encased_column
