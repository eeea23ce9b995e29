// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/kriging.h"

#include "openturns_bridge.h"

#include <openturns/GeneralLinearModelAlgorithm.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/LinearBasisFactory.hxx>
#include <openturns/MaternModel.hxx>

#include <cmath>

namespace encased_column {

namespace {

class Kriging : public Surrogate {
 public:
  Kriging(Eigen::MatrixXd points, Eigen::VectorXd reach, Eigen::VectorXd trend,
          Eigen::VectorXd weights)
      : points_(std::move(points)),
        reach_(std::move(reach)),
        trend_(std::move(trend)),
        weights_(std::move(weights))
  {
  }
  double value(const Eigen::VectorXd& point) const override
  {
    double sum = trend_[0] + trend_.tail(point.size()).dot(point);
    for (Eigen::Index n = 0; n < points_.rows(); ++n) {
      const double s = std::sqrt(5.0) *
                       ((point.transpose() - points_.row(n)).array() / reach_.transpose().array())
                           .matrix()
                           .norm();
      sum += weights_[n] * (1.0 + s + s * s / 3.0) * std::exp(-s);
    }
    return sum;
  }

 private:
  Eigen::MatrixXd points_;
  Eigen::VectorXd reach_, trend_, weights_;
};

struct Scaled {
  OT::Sample x, y;
  double mean, spread;
};

Scaled scaled(const Data& data)
{
  show_errors_only();
  const double mean = data.values.mean();
  double spread = std::sqrt((data.values.array() - mean).square().mean());
  if (!(spread > 1e-12 * std::abs(mean))) spread = 1.0;
  return {sample_of(data.points), sample_of((data.values.array() - mean) / spread), mean, spread};
}

OT::MaternModel model_of(const KrigingShape& shape)
{
  OT::MaternModel model(point_of(shape.reach), OT::Point(1, shape.amplitude), 2.5);
  model.setNuggetFactor(shape.nugget);
  return model;
}

/// `shape` with the reach and amplitude, or the amplitude alone, that suit the data best; returns
/// the logarithm of their likelihood.
double improve(KrigingShape& shape, const Scaled& data, bool reach_too)
{
  OT::GeneralLinearModelAlgorithm fit(data.x, data.y, model_of(shape),
                                      OT::LinearBasisFactory(data.x.getDimension()).build());
  fit.setOptimizeParameters(reach_too);
  fit.run();
  const OT::GeneralLinearModelResult result = fit.getResult();
  shape.reach = vector_of(result.getCovarianceModel().getScale());
  shape.amplitude = result.getCovarianceModel().getAmplitude()[0];
  return result.getOptimalLogLikelihood();
}

}  // namespace

KrigingShape kriging_shape(const Data& data)
{
  const Scaled standard = scaled(data);
  KrigingShape shape{Eigen::VectorXd::Constant(data.points.cols(), 0.7), 1.0, 1e-3};
  improve(shape, standard, true);
  KrigingShape best = shape;
  double likelihood = -HUGE_VAL;
  for (const double nugget : kriging_nuggets) {
    KrigingShape other = shape;
    other.nugget = nugget;
    const double found = improve(other, standard, true);
    if (found > likelihood) {
      likelihood = found;
      best = other;
    }
  }
  return best;
}

std::unique_ptr<Surrogate> fit_kriging(const Data& data, const KrigingShape& shape)
{
  const Scaled standard = scaled(data);
  OT::KrigingAlgorithm algorithm(standard.x, standard.y, model_of(shape),
                                 OT::LinearBasisFactory(standard.x.getDimension()).build());
  algorithm.setOptimizeParameters(false);
  algorithm.run();
  const OT::KrigingResult result = algorithm.getResult();
  Eigen::VectorXd trend = standard.spread * vector_of(result.getTrendCoefficients()[0]);
  trend[0] += standard.mean;
  // OpenTURNS's weights stand in front of the covariance.
  const Eigen::VectorXd weights = standard.spread * shape.amplitude * shape.amplitude *
                                  matrix_of(result.getCovarianceCoefficients()).col(0);
  return std::make_unique<Kriging>(data.points, shape.reach, trend, weights);
}

}  // namespace encased_column
