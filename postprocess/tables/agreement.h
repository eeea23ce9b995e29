// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"

#include <cmath>
#include <string>
#include <vector>

namespace encased_column {

/// Part of a laboratory's value that a run may be off and still has met it.
constexpr double near_laboratory = 0.15;

/// A number of the tests beside the laboratory's, or the study's where the laboratory has none.
struct AgreementNumber {
  std::string tests;     ///< "plain", "encased" or "column"; the set of parameters if there are
                         ///< several
  std::string quantity;  ///< "E50", "peak q", "φ", "c", or as the study calls it
  std::string at;        ///< "50 kPa", the confining stress; empty where it is of all tests
  std::string unit;
  double found, published;  ///< in `unit`
  double allowed;           ///< what `found` may be off [`unit`]
  bool of_laboratory;       ///< false: of the study's model

  /// Met: within `allowed` of it.
  bool near() const { return std::abs(found - published) <= allowed * (1.0 + 1e-9); }
  double ratio() const { return found / published; }
  /// "E50 at 50 kPa".
  std::string name() const { return at.empty() ? quantity : quantity + " at " + at; }
};

/// What cohesion [Pa] may be off beside that: it stands where the line through the peaks meets no
/// stress, and moves by (1 - sin phi) / (2 cos phi) of what moves the smallest peak.
///
/// Source: Mohr-Coulomb at sigma3 = const, q = 2 c cos phi / (1 - sin phi) + ..., solved for c.
double cohesion_allowance(double smallest_peak, double friction_angle);

/// What tells most: E50, friction angle and cohesion of plain and of encased tests, peak q where
/// the tests give no failure line, and all numbers that the study tells of its columns but the
/// porosity that the deck was given. Those of `targets` that no run gives are left out, and runs
/// that reproduce nothing of the study. Each may be off by near_laboratory of the published value,
/// cohesion by cohesion_allowance if that is more. The page and the terminal tell the same list.
std::vector<AgreementNumber> agreement_numbers(const std::vector<SetResult>& sets,
                                               const Targets& targets);

/// What is said where agreement_numbers() has nothing.
extern const char* const nothing_to_compare;

/// "Met within 15 % of the laboratory: 6 of 8 values", or of the study if it has one of its model.
/// There must be a number.
std::string met_count(const std::vector<AgreementNumber>& numbers);

/// The same and what is farthest off of those not met: "...; farthest off: E50 at 50 kPa (plain),
/// 0.50 times it.".
std::string agreement_sentence(const std::vector<AgreementNumber>& numbers);

/// Three digits: enough beside published values.
std::string in_three_digits(double value);

}  // namespace encased_column
