// SPDX-License-Identifier: GPL-2.0-only
#include "search/posterior.h"

#include "openturns_bridge.h"

#include <openturns/Interval.hxx>
#include <openturns/Normal.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/RandomVector.hxx>
#include <openturns/RandomWalkMetropolisHastings.hxx>

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

constexpr int chains = 4;
constexpr int thinning = 5;
constexpr OT::UnsignedInteger pilot_samples = 600, burn_in = 500;

struct Walk {
  Eigen::MatrixXd points;
  double acceptance;
};

Walk walk(const OT::Function& density, const OT::Point& start, const Eigen::MatrixXd& steps,
          OT::UnsignedInteger samples)
{
  const OT::UnsignedInteger dimensions = density.getInputDimension();
  OT::CovarianceMatrix covariance(dimensions);
  for (OT::UnsignedInteger i = 0; i < dimensions; ++i)
    for (OT::UnsignedInteger j = 0; j <= i; ++j)
      covariance(i, j) = steps(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  OT::RandomWalkMetropolisHastings sampler(density, OT::Interval(dimensions), start,
                                           OT::Normal(OT::Point(dimensions), covariance));
  sampler.setBurnIn(burn_in);
  sampler.setThinning(thinning);
  const OT::RandomVector vector(sampler);
  const Eigen::MatrixXd points = matrix_of(vector.getSample(samples));
  const auto* used =
      dynamic_cast<const OT::RandomWalkMetropolisHastings*>(vector.getImplementation().get());
  return {points, used->getAcceptanceRate()};
}

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& points)
{
  const Eigen::MatrixXd centred = points.rowwise() - points.colwise().mean();
  return centred.transpose() * centred / static_cast<double>(points.rows() - 1);
}

/// R of Gelman and Rubin (Statist. Sci. 7, 1992, 457-472): what the spread of all chains together
/// is more than that inside them.
Eigen::VectorXd mixing_of(const std::vector<Eigen::MatrixXd>& parts)
{
  const double length = static_cast<double>(parts.front().rows());
  const Eigen::Index dimensions = parts.front().cols();
  Eigen::MatrixXd means(static_cast<Eigen::Index>(parts.size()), dimensions);
  Eigen::VectorXd inside = Eigen::VectorXd::Zero(dimensions);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    means.row(static_cast<Eigen::Index>(n)) = parts[n].colwise().mean();
    inside += covariance_of(parts[n]).diagonal() / static_cast<double>(parts.size());
  }
  const Eigen::VectorXd between = covariance_of(means).diagonal();
  return ((length - 1.0) / length + between.array() / inside.array().max(1e-300)).sqrt();
}

}  // namespace

Posterior sample_posterior(const CubeFunction& log_likelihood, const Eigen::VectorXd& start,
                           int samples, unsigned seed)
{
  OT::RandomGenerator::SetSeed(seed);
  const int dimensions = static_cast<int>(start.size());
  const auto one = [&](const Eigen::VectorXd& point) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, log_likelihood(point));
  };
  const OT::Function density = function_of(dimensions, 1, one);
  Eigen::MatrixXd steps = 1e-3 * Eigen::MatrixXd::Identity(dimensions, dimensions);
  // The best size of steps: A. Gelman, W. R. Gilks, G. O. Roberts, Ann. Appl. Probab. 7 (1997).
  const double best = 2.38 * 2.38 / dimensions;
  OT::Point from = point_of(start);
  for (int pilot = 0; pilot < 3; ++pilot) {
    const Eigen::MatrixXd points = walk(density, from, steps, pilot_samples).points;
    steps = best * covariance_of(points) + 1e-8 * Eigen::MatrixXd::Identity(dimensions, dimensions);
    from = point_of(points.row(points.rows() - 1).transpose());
  }
  Posterior result{Eigen::MatrixXd(0, dimensions), 0.0, {}};
  std::vector<Eigen::MatrixXd> parts;
  for (int chain = 0; chain < chains; ++chain) {
    const Walk found =
        walk(density, from, steps, static_cast<OT::UnsignedInteger>(samples / chains));
    parts.push_back(found.points);
    result.acceptance += found.acceptance / chains;
  }
  result.mixing = mixing_of(parts);
  for (const Eigen::MatrixXd& part : parts) {
    Eigen::MatrixXd all(result.points.rows() + part.rows(), dimensions);
    all << result.points, part;
    result.points = std::move(all);
  }
  return result;
}

double quantile(Eigen::VectorXd column, double level)
{
  std::sort(column.begin(), column.end());
  const double place = level * static_cast<double>(column.size() - 1);
  const auto below = static_cast<Eigen::Index>(place);
  const Eigen::Index above = std::min(below + 1, column.size() - 1);
  const double part = place - static_cast<double>(below);
  return (1.0 - part) * column[below] + part * column[above];
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& points)
{
  const Eigen::MatrixXd covariance = covariance_of(points);
  const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(points.cols(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (Eigen::Index j = 0; j < points.cols(); ++j)
      if (i != j && deviation[i] * deviation[j] > 0.0)
        result(i, j) = covariance(i, j) / deviation[i] / deviation[j];
      else if (i != j)
        result(i, j) = 0.0;
  return result;
}

}  // namespace encased_column
