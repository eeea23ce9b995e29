// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace encased_column {

/// What a row of targets.csv says about the test that its value is of.
struct TargetCondition {
  std::optional<double> confining_stress;          ///< "sigma3=50 kPa" [Pa]
  std::optional<double> relative_density;          ///< "Dr=80 %" [-]
  std::optional<double> slenderness;               ///< "L/D=5" [-]
  std::optional<double> displacement;              ///< "at 24 mm", of the platens [m]
  std::optional<double> elongation;                ///< "8 % elongation", of a strip [-]
  std::optional<std::pair<double, double>> range;  ///< "range 4 to 5", in the row's unit
  std::string gradation;                           ///< "S2"; empty: not named
};

/// Reads the words that TargetCondition shows out of `text`; all else in it is for readers.
TargetCondition target_condition(const std::string& text);

/// What a test has of that.
struct TestCondition {
  double confining_stress;                 ///< [Pa]
  std::optional<double> relative_density;  ///< [-]
  double slenderness;                      ///< height over diameter [-]
  std::string gradation;                   ///< as in TargetCondition
};

/// Whether a value of `target` may stand beside `test`. A row that names no relative density is of
/// `usual_density`, and a test whose own is not known may be that, but no other.
bool meets(const TestCondition& test, const TargetCondition& target,
           std::optional<double> usual_density);

}  // namespace encased_column
