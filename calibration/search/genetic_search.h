// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <vector>

namespace encased_column {

using CubeFunction = std::function<double(const Eigen::VectorXd&)>;

/// A point of the unit cube and what was to be small there.
struct Found {
  Eigen::VectorXd point;
  std::vector<double> values;
};

/// The point of the unit cube of `dimensions` where `objective` is smallest: pagmo's genetic
/// algorithm `sga`, a hundred points for a hundred generations, and from its best one a local
/// search (COBYLA). The same for the same seed.
Found genetic_search(const CubeFunction& objective, int dimensions, unsigned seed);

/// Points of which none is better than another in both objectives, by rising `first`: pagmo's
/// `nsga2`.
std::vector<Found> pareto_search(const CubeFunction& first, const CubeFunction& second,
                                 int dimensions, unsigned seed);

}  // namespace encased_column
