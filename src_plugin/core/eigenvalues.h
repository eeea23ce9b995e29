// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Core>

namespace encased_column {

/// Eigenvalues of a symmetric matrix, the smallest first (Eigen's solver, compiled once).
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace encased_column
