// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/polynomial.h"

#include "openturns_bridge.h"

#include <openturns/CorrectedLeaveOneOut.hxx>
#include <openturns/FixedStrategy.hxx>
#include <openturns/FunctionalChaosAlgorithm.hxx>
#include <openturns/HyperbolicAnisotropicEnumerateFunction.hxx>
#include <openturns/LARS.hxx>
#include <openturns/LeastSquaresMetaModelSelectionFactory.hxx>
#include <openturns/LeastSquaresStrategy.hxx>
#include <openturns/LegendreFactory.hxx>
#include <openturns/OrthogonalProductPolynomialFactory.hxx>

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

constexpr int highest_degree = 14;
constexpr double interactions = 0.75;  // below 1: fewer terms of many parameters at once

/// Orthonormal Legendre polynomials up to `most` at `share` of the range.
void legendre(double share, int most, std::vector<double>& values)
{
  const double x = 2.0 * share - 1.0;
  values.assign(static_cast<std::size_t>(most) + 1, 1.0);
  if (most > 0) values[1] = x;
  for (std::size_t n = 1; n < static_cast<std::size_t>(most); ++n) {
    const double k = static_cast<double>(n);
    values[n + 1] = ((2.0 * k + 1.0) * x * values[n] - k * values[n - 1]) / (k + 1.0);
  }
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] *= std::sqrt(2.0 * static_cast<double>(n) + 1.0);
}

/// The degree whose terms are no more than the points: more could not be told apart.
int degree_for(const OT::HyperbolicAnisotropicEnumerateFunction& terms, Eigen::Index points)
{
  int degree = 1;
  while (degree < highest_degree && static_cast<Eigen::Index>(terms.getMaximumDegreeCardinal(
                                        static_cast<OT::UnsignedInteger>(degree + 1))) <= points)
    ++degree;
  return degree;
}

}  // namespace

double Polynomial::value(const Eigen::VectorXd& point) const
{
  return (terms_at(point.transpose()) * coefficients_)[0];
}

Eigen::MatrixXd Polynomial::terms_at(const Eigen::MatrixXd& points) const
{
  const auto dimensions = static_cast<std::size_t>(points.cols());
  std::vector<int> most(dimensions, 0);
  for (const std::vector<int>& term : degrees_)
    for (std::size_t i = 0; i < dimensions; ++i) most[i] = std::max(most[i], term[i]);
  Eigen::MatrixXd terms =
      Eigen::MatrixXd::Ones(points.rows(), static_cast<Eigen::Index>(degrees_.size()));
  std::vector<double> values;
  for (Eigen::Index row = 0; row < points.rows(); ++row)
    for (std::size_t i = 0; i < dimensions; ++i) {
      if (most[i] == 0) continue;
      legendre(points(row, static_cast<Eigen::Index>(i)), most[i], values);
      for (std::size_t k = 0; k < degrees_.size(); ++k)
        terms(row, static_cast<Eigen::Index>(k)) *=
            values[static_cast<std::size_t>(degrees_[k][i])];
    }
  return terms;
}

Polynomial fit_polynomial(const Data& data)
{
  const auto dimensions = static_cast<std::size_t>(data.points.cols());
  const std::vector<int> constant(dimensions, 0);
  const double mean = data.values.mean();
  const double spread = std::sqrt((data.values.array() - mean).square().mean());
  if (!(spread > 1e-12 * std::abs(mean))) return {{constant}, Eigen::VectorXd::Constant(1, mean)};

  const OT::HyperbolicAnisotropicEnumerateFunction order(dimensions, interactions);
  const OT::OrthogonalProductPolynomialFactory basis(
      OT::OrthogonalProductPolynomialFactory::PolynomialFamilyCollection(dimensions,
                                                                         OT::LegendreFactory()),
      order);
  const auto size = order.getMaximumDegreeCardinal(
      static_cast<OT::UnsignedInteger>(degree_for(order, data.size())));
  // Standardised, lest the scale of a value (MPa or a strain) decide what counts as small.
  const OT::Sample x = sample_of(2.0 * data.points.array() - 1.0);
  const OT::Sample y = sample_of((data.values.array() - mean) / spread);
  const OT::LeastSquaresStrategy regression(
      x, y, OT::LeastSquaresMetaModelSelectionFactory(OT::LARS(), OT::CorrectedLeaveOneOut()));
  OT::FunctionalChaosAlgorithm algorithm(x, y,
                                         uniform_cube(static_cast<int>(dimensions), -1.0, 1.0),
                                         OT::FixedStrategy(basis, size), regression);
  algorithm.run();
  const OT::FunctionalChaosResult result = algorithm.getResult();

  std::vector<std::vector<int>> degrees{constant};
  std::vector<double> coefficients{mean};
  for (OT::UnsignedInteger k = 0; k < result.getIndices().getSize(); ++k) {
    const OT::Indices term = order(result.getIndices()[k]);
    const double coefficient = spread * result.getCoefficients()(k, 0);
    const std::vector<int> degree(term.begin(), term.end());
    if (degree == constant)
      coefficients.front() += coefficient;
    else {
      degrees.push_back(degree);
      coefficients.push_back(coefficient);
    }
  }
  return {degrees, Eigen::Map<Eigen::VectorXd>(coefficients.data(),
                                               static_cast<Eigen::Index>(coefficients.size()))};
}

}  // namespace encased_column
