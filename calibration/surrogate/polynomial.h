// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "surrogate/surrogate.h"

#include <vector>

namespace encased_column {

/// A polynomial in products of Legendre's polynomials, orthonormal over the unit cube:
///
///   y(x) = sum_k c_k prod_i sqrt(2 a_ki + 1) P_a_ki(2 x_i - 1),
///
/// with few terms. As the terms are orthonormal, the squares of the coefficients add up to the
/// variance of y where all points of the cube are equally likely.
class Polynomial : public Surrogate {
 public:
  Polynomial(std::vector<std::vector<int>> degrees, Eigen::VectorXd coefficients)
      : degrees_(std::move(degrees)),
        coefficients_(std::move(coefficients))
  {
  }

  double value(const Eigen::VectorXd& point) const override;
  /// The terms at `points`, one row a point and one column a term.
  Eigen::MatrixXd terms_at(const Eigen::MatrixXd& points) const;

  const std::vector<std::vector<int>>& degrees() const { return degrees_; }  ///< [term][parameter]
  const Eigen::VectorXd& coefficients() const { return coefficients_; }

 private:
  std::vector<std::vector<int>> degrees_;
  Eigen::VectorXd coefficients_;
};

/// Regularised regression: of all terms up to a degree that the number of points allows, least
/// angle regression adds the most useful ones, and leave-one-out cross-validation stops it. Source:
/// G. Blatman, B. Sudret, "Adaptive sparse polynomial chaos expansion based on least angle
/// regression", J. Comput. Phys. 230 (2011), 2345-2367.
/// A constant where all values are the same. Needs two points at least.
Polynomial fit_polynomial(const Data& data);

}  // namespace encased_column
