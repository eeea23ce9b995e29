// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <openturns/ComposedDistribution.hxx>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Function.hxx>
#include <openturns/Log.hxx>
#include <openturns/Sample.hxx>
#include <openturns/Uniform.hxx>

#include <functional>

// OpenTURNS has types of its own; nothing outside of the sources that call it sees them.
namespace encased_column {

inline OT::Point point_of(const Eigen::VectorXd& from)
{
  OT::Point point(static_cast<OT::UnsignedInteger>(from.size()));
  for (Eigen::Index i = 0; i < from.size(); ++i)
    point[static_cast<OT::UnsignedInteger>(i)] = from[i];
  return point;
}

inline Eigen::VectorXd vector_of(const OT::Point& from)
{
  Eigen::VectorXd vector(static_cast<Eigen::Index>(from.getSize()));
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    vector[i] = from[static_cast<OT::UnsignedInteger>(i)];
  return vector;
}

inline OT::Sample sample_of(const Eigen::MatrixXd& from)
{
  OT::Sample sample(static_cast<OT::UnsignedInteger>(from.rows()),
                    static_cast<OT::UnsignedInteger>(from.cols()));
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    for (Eigen::Index j = 0; j < from.cols(); ++j)
      sample(static_cast<OT::UnsignedInteger>(i), static_cast<OT::UnsignedInteger>(j)) = from(i, j);
  return sample;
}

inline Eigen::MatrixXd matrix_of(const OT::Sample& from)
{
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(from.getSize()),
                         static_cast<Eigen::Index>(from.getDimension()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      matrix(i, j) = from(static_cast<OT::UnsignedInteger>(i), static_cast<OT::UnsignedInteger>(j));
  return matrix;
}

inline OT::ComposedDistribution uniform_cube(int dimensions, double low, double high)
{
  return OT::ComposedDistribution(OT::ComposedDistribution::DistributionCollection(
      static_cast<OT::UnsignedInteger>(dimensions), OT::Uniform(low, high)));
}

/// A function of ours as OpenTURNS calls it.
class CalledFunction : public OT::EvaluationImplementation {
 public:
  using Body = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
  CalledFunction(int inputs, int outputs, Body body)
      : inputs_(static_cast<OT::UnsignedInteger>(inputs)),
        outputs_(static_cast<OT::UnsignedInteger>(outputs)),
        body_(std::move(body))
  {
    setInputDescription(OT::Description::BuildDefault(inputs_, "x"));
    setOutputDescription(OT::Description::BuildDefault(outputs_, "y"));
  }
  CalledFunction* clone() const override { return new CalledFunction(*this); }
  OT::Bool isActualImplementation() const override { return true; }
  OT::UnsignedInteger getInputDimension() const override { return inputs_; }
  OT::UnsignedInteger getOutputDimension() const override { return outputs_; }
  using OT::EvaluationImplementation::operator();
  OT::Point operator()(const OT::Point& point) const override
  {
    return point_of(body_(vector_of(point)));
  }

 private:
  OT::UnsignedInteger inputs_, outputs_;
  Body body_;
};

/// Warnings of OpenTURNS name nothing that a user can mend: bounds set to suit the points, a local
/// search cut short.
inline void show_errors_only()
{
  OT::Log::Show(OT::Log::ERROR);
}

inline OT::Function function_of(int inputs, int outputs, CalledFunction::Body body)
{
  show_errors_only();
  return OT::Function(CalledFunction(inputs, outputs, std::move(body)));
}

}  // namespace encased_column
