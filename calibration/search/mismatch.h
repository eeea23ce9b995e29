// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace encased_column {

/// A value of the laboratory that runs are to meet.
struct Goal {
  std::string name;  ///< "secant_modulus of plain_050"
  double value;      ///< SI
  double tolerance;  ///< SI; a value within it is met. Taken as the 95 % interval of the laboratory
  double weight = 1.0;   ///< 0: foretold and compared, not fitted
  double deviation = 0;  ///< standard deviation of laboratory, packings and surrogate together
};

/// Standard deviations that belong to a 95 % interval of half width 1.
constexpr double deviation_of_interval = 1.0 / 1.959964;

/// Standard deviation of laboratory value minus foretold one: the laboratory's, and the larger one
/// of the scatter between packings and the surrogate's error, which holds that scatter.
double combined_deviation(double tolerance, double packing_scatter, double surrogate_error);

/// Sum of weight ((value - goal) / deviation)^2; goals without a value (not a number) cost as much
/// as ten deviations.
double mismatch(const Eigen::VectorXd& values, const std::vector<Goal>& goals);

/// True if all goals with a weight are met within their tolerance.
bool all_met(const Eigen::VectorXd& values, const std::vector<Goal>& goals);

/// Standard deviation of one run about the mean of its point, pooled over points with several runs;
/// 0 where there is none. `values` and `groups` of one length; not-a-numbers are left out.
double pooled_scatter(const Eigen::VectorXd& values, const std::vector<int>& groups);

}  // namespace encased_column
