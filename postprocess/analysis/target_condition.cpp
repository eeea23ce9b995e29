// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/target_condition.h"

#include <array>
#include <cmath>
#include <regex>

namespace encased_column {

namespace {

struct ConditionWord {
  std::regex pattern;
  std::optional<double> TargetCondition::*member;
  double factor;  ///< to SI
};

const std::array<ConditionWord, 5>& condition_words()
{
  static const std::array<ConditionWord, 5> words{{
      {std::regex(R"(\bsigma3=([0-9.]+) kPa)"), &TargetCondition::confining_stress, 1e3},
      {std::regex(R"(\bDr=([0-9.]+) %)"), &TargetCondition::relative_density, 1e-2},
      {std::regex(R"(\bL/D=([0-9.]+))"), &TargetCondition::slenderness, 1.0},
      {std::regex(R"(\bat ([0-9.]+) mm)"), &TargetCondition::displacement, 1e-3},
      {std::regex(R"(\b([0-9.]+) % elongation)"), &TargetCondition::elongation, 1e-2},
  }};
  return words;
}

constexpr double same_stress = 1e-3;       // shares and differences that count as none
constexpr double same_density = 5e-3;      // [-]
constexpr double same_slenderness = 0.05;  // a specimen is somewhat shorter when shear starts

}  // namespace

TargetCondition target_condition(const std::string& text)
{
  TargetCondition condition;
  std::smatch found;
  for (const ConditionWord& word : condition_words())
    if (std::regex_search(text, found, word.pattern))
      condition.*word.member = word.factor * std::stod(found[1]);
  static const std::regex range(R"(\brange ([0-9.]+) to ([0-9.]+))");
  if (std::regex_search(text, found, range))
    condition.range = std::pair(std::stod(found[1]), std::stod(found[2]));
  static const std::regex gradation(R"(\b(S[0-9]+)\b)");
  if (std::regex_search(text, found, gradation)) condition.gradation = found[1];
  return condition;
}

bool meets(const TestCondition& test, const TargetCondition& target,
           std::optional<double> usual_density)
{
  if (target.confining_stress &&
      std::abs(test.confining_stress / *target.confining_stress - 1.0) > same_stress)
    return false;
  if (target.slenderness &&
      std::abs(test.slenderness / *target.slenderness - 1.0) > same_slenderness)
    return false;
  if (!target.gradation.empty() && target.gradation != test.gradation) return false;
  if (!test.relative_density) return !target.relative_density;
  const std::optional<double> wanted =
      target.relative_density ? target.relative_density : usual_density;
  return !wanted || std::abs(*test.relative_density - *wanted) < same_density;
}

}  // namespace encased_column
