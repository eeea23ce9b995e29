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
  std::string quantity;  ///< "E50 at 50 kPa"
  std::string unit;
  std::string found, published;
  double ratio;
  bool of_laboratory;  ///< false: of the study's model

  /// Within near_laboratory of it.
  bool near() const { return std::abs(ratio - 1.0) < near_laboratory + 1e-9; }
};

/// What tells most: E50, friction angle and cohesion of plain and of encased tests, peak q where
/// the tests give no failure line, and all numbers that the study tells of its columns. Those of
/// `targets` that no run gives are left out.
std::vector<AgreementNumber> agreement_numbers(const std::vector<SetResult>& sets,
                                               const Targets& targets);

/// "6 of 8 numbers lie within 15 % of the laboratory's; farthest off: ...".
std::string agreement_sentence(const std::vector<AgreementNumber>& numbers);

}  // namespace encased_column
