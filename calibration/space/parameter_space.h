// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace encased_column {

/// A variable of the decks that is looked for, and where.
struct Parameter {
  std::string name;  ///< as the deck calls it
  std::string unit;  ///< "Pa"; "-" where there is none
  double low, high;  ///< in SI units, low < high
  bool logarithmic = false;
  std::vector<std::string> also{};  ///< variables that take the same value
};

/// The ranges of all parameters. Designs, surrogates and searches work in the unit cube, where each
/// parameter goes from 0 at `low` to 1 at `high`, along its logarithm where it says so.
class ParameterSpace {
 public:
  ParameterSpace() = default;
  explicit ParameterSpace(std::vector<Parameter> parameters) : parameters_(std::move(parameters)) {}

  int size() const { return static_cast<int>(parameters_.size()); }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const Parameter& operator[](int i) const { return parameters_[static_cast<std::size_t>(i)]; }

  /// Value [SI] of parameter `i` at `share` of its range [-].
  double value(int i, double share) const;
  /// The inverse.
  double share(int i, double value) const;
  /// All values at a point of the unit cube.
  std::vector<double> values(const Eigen::VectorXd& point) const;

 private:
  std::vector<Parameter> parameters_;
};

}  // namespace encased_column
