// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// What runs gave for one value: points of the unit cube, one a row, and the value at each. Rows of
/// the same `group` are of the same point, repeated with another packing.
struct Data {
  Eigen::MatrixXd points;
  Eigen::VectorXd values;
  std::vector<int> groups;
  bool proportional = false;  ///< positive, and scatters the more the larger it is

  Eigen::Index size() const { return values.size(); }
  /// The rows of these numbers.
  Data rows(const std::vector<Eigen::Index>& chosen) const;
  /// With the logarithms of the values, which scatter alike everywhere.
  Data logarithms() const;
};

/// A cheap formula for a value that takes a run of minutes.
class Surrogate {
 public:
  virtual ~Surrogate() = default;
  /// The value at a point of the unit cube.
  virtual double value(const Eigen::VectorXd& point) const = 0;
};

enum class SurrogateKind { polynomial, network, kriging };

/// "regression", "network" or "Kriging", as reports call them.
std::string name_of(SurrogateKind kind);

using Fit = std::function<std::unique_ptr<Surrogate>(const Data&)>;

/// How a surrogate of this kind is fitted to `data` or a part of it; the same for the same seed. To
/// what scatters in proportion by its logarithms: it then foretells the median. Of
/// Kriging the shape is found once, from all of `data`: that takes long and depends little on a
/// part that is left out.
Fit fit_of(SurrogateKind kind, const Data& data, unsigned seed);

}  // namespace encased_column
