// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

namespace encased_column {

enum class DesignKind { sobol, latin_hypercube };

/// Points of the unit cube of `dimensions` that fill it evenly, one a row; the same for the same
/// seed. `sobol`: Sobol's sequence, shifted by `seed`; more points may be added behind the first.
/// `latin_hypercube`: each parameter takes each of `points` equal steps once, and of many such
/// tables the one that keeps its points apart best (phi_p of Morris and Mitchell, 1995).
Eigen::MatrixXd space_filling_design(DesignKind kind, int points, int dimensions, unsigned seed);

}  // namespace encased_column
