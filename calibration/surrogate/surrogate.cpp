// SPDX-License-Identifier: GPL-2.0-only
#include "surrogate/surrogate.h"

#include "surrogate/kriging.h"
#include "surrogate/network.h"
#include "surrogate/polynomial.h"

#include <cmath>

namespace encased_column {

Data Data::rows(const std::vector<Eigen::Index>& chosen) const
{
  Data part{{static_cast<Eigen::Index>(chosen.size()), points.cols()},
            Eigen::VectorXd(static_cast<Eigen::Index>(chosen.size())),
            {},
            proportional};
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    part.points.row(static_cast<Eigen::Index>(n)) = points.row(chosen[n]);
    part.values[static_cast<Eigen::Index>(n)] = values[chosen[n]];
    part.groups.push_back(groups[static_cast<std::size_t>(chosen[n])]);
  }
  return part;
}

Data Data::logarithms() const
{
  Data logs = *this;
  logs.values = values.array().log();
  logs.proportional = false;
  return logs;
}

namespace {

class Exponential : public Surrogate {
 public:
  explicit Exponential(std::unique_ptr<Surrogate> exponent) : exponent_(std::move(exponent)) {}
  double value(const Eigen::VectorXd& point) const override
  {
    return std::exp(exponent_->value(point));
  }

 private:
  std::unique_ptr<Surrogate> exponent_;
};

}  // namespace

std::string name_of(SurrogateKind kind)
{
  switch (kind) {
    case SurrogateKind::polynomial:
      return "regression";
    case SurrogateKind::network:
      return "network";
    case SurrogateKind::kriging:
      break;
  }
  return "Kriging";
}

Fit fit_of(SurrogateKind kind, const Data& data, unsigned seed)
{
  if (data.proportional)
    return [fit = fit_of(kind, data.logarithms(), seed)](const Data& part) {
      return std::make_unique<Exponential>(fit(part.logarithms()));
    };
  switch (kind) {
    case SurrogateKind::polynomial:
      return [](const Data& part) { return std::make_unique<Polynomial>(fit_polynomial(part)); };
    case SurrogateKind::network:
      return [seed](const Data& part) { return fit_network(part, seed); };
    case SurrogateKind::kriging:
      break;
  }
  return [shape = kriging_shape(data)](const Data& part) { return fit_kriging(part, shape); };
}

}  // namespace encased_column
