// SPDX-License-Identifier: GPL-2.0-only
#include "core/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace encased_column {

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace encased_column
