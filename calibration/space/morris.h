// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace encased_column {

constexpr int usual_morris_levels = 4;

/// Ways through the unit cube that change one parameter at a time. Way w has the points
/// w (d + 1) to w (d + 1) + d; `changed` tells which parameter changes behind each of its first d
/// points, `step` by how much.
struct MorrisPlan {
  Eigen::MatrixXd points;    ///< one a row
  std::vector<int> changed;  ///< d for each way
  double step;               ///< [-] of the range; its sign is that of the points
};

/// `ways` random ways on a grid of `levels` (even) values for each parameter, with the step
/// levels / (2 (levels - 1)), so that all levels are equally likely.
/// Source: M. D. Morris, "Factorial sampling plans for preliminary computational experiments",
/// Technometrics 33 (1991), 161-174.
MorrisPlan morris_plan(int ways, int dimensions, int levels, unsigned seed);

/// What one parameter does to a value: statistics of its elementary effects, the change of the
/// value over the change of the parameter, in units of the value for the whole range.
struct MorrisEffect {
  double mean = 0.0;            ///< mu
  double mean_size = 0.0;       ///< mu*, mean of the absolute effects
  double deviation = 0.0;       ///< sigma: curvature and interaction with others
  double standard_error = 0.0;  ///< of mu*, from the scatter between ways; 0 with one way
  int effects = 0;              ///< that were found: less where runs failed
};

/// The effects of each parameter. `values` holds one for each point, not a number where there is
/// none.
std::vector<MorrisEffect> morris_effects(const MorrisPlan& plan, const Eigen::VectorXd& values);

}  // namespace encased_column
