// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "surrogate/surrogate.h"

namespace encased_column {

/// How a Gaussian process varies over the unit cube.
struct KrigingShape {
  Eigen::VectorXd reach;  ///< of the correlation along each parameter [-] of its range
  double amplitude;       ///< of the process, values standardised [-]
  double nugget;          ///< variance of the noise over that of the process [-]
};

/// The shape that makes `data` most likely: noise one of `kriging_nuggets`.
KrigingShape kriging_shape(const Data& data);

/// Kriging: a plane through all points and, on top, a Gaussian process with Matern's correlation
/// for nu = 5/2, (1 + s + s^2 / 3) exp(-s) with s = sqrt(5) |(x - x') / reach|.
std::unique_ptr<Surrogate> fit_kriging(const Data& data, const KrigingShape& shape);

constexpr double kriging_nuggets[] = {1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.5};

}  // namespace encased_column
