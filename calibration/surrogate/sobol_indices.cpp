// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/sobol_indices.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace encased_column {

namespace {

/// First indices of all parameters and, behind them, total ones.
Eigen::VectorXd shares(const std::vector<std::vector<int>>& degrees,
                       const Eigen::VectorXd& coefficients)
{
  const auto parameters = static_cast<Eigen::Index>(degrees.front().size());
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(2 * parameters);
  double variance = 0.0;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const auto active =
        std::count_if(degrees[k].begin(), degrees[k].end(), [](int one) { return one > 0; });
    if (active == 0) continue;
    const double part = std::pow(coefficients[static_cast<Eigen::Index>(k)], 2);
    variance += part;
    for (Eigen::Index i = 0; i < parameters; ++i) {
      if (degrees[k][static_cast<std::size_t>(i)] == 0) continue;
      if (active == 1) sums[i] += part;
      sums[parameters + i] += part;
    }
  }
  return variance > 0.0 ? Eigen::VectorXd(sums / variance) : sums;
}

/// Leave-one-out error over the variance, from one fit: each residual over what its own point
/// leaves free.
double unexplained_share(const Eigen::MatrixXd& terms, const Data& data)
{
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(terms);
  const Eigen::MatrixXd q =
      qr.householderQ() * Eigen::MatrixXd::Identity(terms.rows(), terms.cols());
  const Eigen::VectorXd rest = data.values - q * (q.transpose() * data.values);
  double sum = 0.0;
  for (Eigen::Index row = 0; row < rest.size(); ++row)
    sum += std::pow(rest[row] / std::max(1.0 - q.row(row).squaredNorm(), 1e-12), 2);
  const double variance = (data.values.array() - data.values.mean()).square().sum();
  return variance > 0.0 ? std::min(sum / variance, 1.0) : 0.0;
}

}  // namespace

SobolIndices sobol_indices(const Polynomial& polynomial, const Data& data, int resamples,
                           unsigned seed)
{
  const Eigen::MatrixXd terms = polynomial.terms_at(data.points);
  const Eigen::VectorXd found = shares(polynomial.degrees(), polynomial.coefficients());
  std::mt19937 random(seed);
  Eigen::VectorXd square = Eigen::VectorXd::Zero(found.size());
  for (int n = 0; n < resamples; ++n) {
    Eigen::MatrixXd drawn_terms(terms.rows(), terms.cols());
    Eigen::VectorXd drawn_values(terms.rows());
    for (Eigen::Index row = 0; row < terms.rows(); ++row) {
      const auto from = static_cast<Eigen::Index>(random() % static_cast<unsigned>(terms.rows()));
      drawn_terms.row(row) = terms.row(from);
      drawn_values[row] = data.values[from];
    }
    const Eigen::VectorXd coefficients =
        drawn_terms.completeOrthogonalDecomposition().solve(drawn_values);
    square += (shares(polynomial.degrees(), coefficients) - found).cwiseAbs2() / resamples;
  }
  SobolIndices indices{{}, {}, unexplained_share(terms, data)};
  const Eigen::Index parameters = found.size() / 2;
  for (Eigen::Index i = 0; i < found.size(); ++i)
    (i < parameters ? indices.first : indices.total)
        .push_back({found[i], 1.96 * std::sqrt(square[i]) + indices.unexplained});
  return indices;
}

}  // namespace encased_column
