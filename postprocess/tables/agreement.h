// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// A number of the tests beside the laboratory's, or the study's where the laboratory has none.
struct AgreementNumber {
  std::string tests;     ///< "plain", "encased" or "column"; the set of parameters if there are
                         ///< several
  std::string quantity;  ///< "E50 at 50 kPa"
  std::string unit;
  std::string found, published;
  double ratio;
  bool of_laboratory;  ///< false: of the study's model

  /// Within 10 % of it.
  bool near() const { return ratio > 0.9 - 1e-9 && ratio < 1.1 + 1e-9; }
};

/// What tells most: E50, friction angle and cohesion of plain and of encased tests, peak q where
/// the tests give no failure line, and all numbers that the study tells of its columns. Those of
/// `targets` that no run gives are left out.
std::vector<AgreementNumber> agreement_numbers(const std::vector<SetResult>& sets,
                                               const Targets& targets);

/// "6 of 8 numbers lie within 10 % of the laboratory's; farthest off: ...".
std::string agreement_sentence(const std::vector<AgreementNumber>& numbers);

}  // namespace encased_column
