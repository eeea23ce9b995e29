// SPDX-License-Identifier: GPL-2.0-only
#include "tables/agreement.h"

#include "core/input_error.h"
#include "tables/target_table.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace encased_column {

namespace {

/// Places in a row of target_rows(); a value and a ratio for each set of parameters follow.
struct TargetCell {
  static constexpr std::size_t set = 0, quantity = 1, unit = 2, condition = 3, laboratory = 4,
                               model = 5, first = 6;
};

const std::string peak_quantity = "peak deviator q";

bool begins_with(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

/// "plain" of plain_triaxial, "column" of column_density.
std::string kind_of_tests(const std::string& set_name)
{
  return set_name.substr(0, set_name.find('_'));
}

/// What a quantity is called in short; empty where it tells nothing of agreement.
std::string short_name(const std::vector<std::string>& row, bool has_line)
{
  const std::string& quantity = row[TargetCell::quantity];
  if (begins_with(row[TargetCell::set], "column")) return quantity == "porosity" ? "" : quantity;
  if (begins_with(quantity, "secant modulus E50")) return "E50";
  if (begins_with(quantity, "apparent friction angle")) return "φ";
  if (begins_with(quantity, "apparent cohesion")) return "c";
  if (begins_with(quantity, peak_quantity) && !has_line) return "peak q";
  return "";
}

/// "50 kPa" of a triaxial test's condition.
std::string stress_of(const std::vector<std::string>& row)
{
  const std::string stress = "sigma3=";
  const std::string& condition = row[TargetCell::condition];
  return begins_with(condition, stress) ? condition.substr(stress.size()) : "";
}

bool of_laboratory(const std::vector<std::string>& row)
{
  return row[TargetCell::laboratory] != "-";
}

double published(const std::vector<std::string>& row)
{
  return std::atof(row[of_laboratory(row) ? TargetCell::laboratory : TargetCell::model].c_str());
}

/// What cohesion may be off in `set` [kPa]: by the smallest published peak [kPa] of those that the
/// tests in `column` stand beside.
double allowance_by_peaks(const Rows& rows, std::size_t column, const std::string& set,
                          const Targets& targets)
{
  double smallest = std::numeric_limits<double>::infinity();
  bool laboratory = true;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const std::vector<std::string>& row = rows[r];
    if (row[TargetCell::set] != set || !begins_with(row[TargetCell::quantity], peak_quantity) ||
        row[column + 1] == "-")
      continue;
    smallest = std::min(smallest, published(row));
    laboratory = laboratory && of_laboratory(row);
  }
  const auto strength = targets.strength(set, laboratory);
  if (!strength || !std::isfinite(smallest)) return 0.0;
  return cohesion_allowance(smallest, strength->friction_angle);
}

}  // namespace

const char* const nothing_to_compare =
    "The laboratory has no values beside which these tests could stand.";

double cohesion_allowance(double smallest_peak, double friction_angle)
{
  return near_laboratory * smallest_peak * (1.0 - std::sin(friction_angle)) /
         (2.0 * std::cos(friction_angle));
}

std::string in_three_digits(double value)
{
  if (std::abs(value) >= 100.0) return fixed(value, 0);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::vector<AgreementNumber> agreement_numbers(const std::vector<SetResult>& sets,
                                               const Targets& targets)
{
  std::vector<AgreementNumber> numbers;
  const Rows rows = target_rows(sets, targets);
  const std::vector<std::string>& headings = rows.front();
  const bool several = headings.size() > TargetCell::first + 2;
  for (std::size_t column = TargetCell::first; column + 1 < headings.size(); column += 2)
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const std::vector<std::string>& row = rows[r];
      const std::string& set = row[TargetCell::set];
      const bool has_line = std::any_of(sets.begin(), sets.end(), [&](const SetResult& s) {
        return s.set == set && s.line && of_study(s) &&
               (!several || headings[column] == "set " + s.parameters());
      });
      const std::string name = short_name(row, has_line);
      if (name.empty() || row[column + 1] == "-") continue;
      double found = std::atof(row[column].c_str());
      if (std::abs(found) < 1e-6) found = 0.0;  // cohesion of -3e-14 kPa is none
      double allowed = near_laboratory * std::abs(published(row));
      if (name == "c") allowed = std::max(allowed, allowance_by_peaks(rows, column, set, targets));
      const bool triaxial = !begins_with(set, "column");
      numbers.push_back({kind_of_tests(set) + (several ? ", " + headings[column] : ""), name,
                         triaxial ? stress_of(row) : "", row[TargetCell::unit], found,
                         published(row), allowed, of_laboratory(row)});
    }
  return numbers;
}

std::string met_count(const std::vector<AgreementNumber>& numbers)
{
  const bool laboratory = std::all_of(numbers.begin(), numbers.end(),
                                      [](const AgreementNumber& n) { return n.of_laboratory; });
  const auto met = std::count_if(numbers.begin(), numbers.end(),
                                 [](const AgreementNumber& n) { return n.near(); });
  return "Met within " + fixed(100.0 * near_laboratory, 0) + " % of the " +
         (laboratory ? "laboratory: " : "study: ") + std::to_string(met) + " of " +
         std::to_string(numbers.size()) + (numbers.size() == 1 ? " value" : " values");
}

std::string agreement_sentence(const std::vector<AgreementNumber>& numbers)
{
  if (numbers.empty()) return nothing_to_compare;
  const auto off = [](const AgreementNumber& n) {
    if (n.near()) return 0.0;
    return std::abs(std::log(std::max(n.ratio(), 1e-3)));  // 2 is as far off as 0.5
  };
  const AgreementNumber& farthest =
      *std::max_element(numbers.begin(), numbers.end(),
                        [&](const auto& a, const auto& b) { return off(a) < off(b); });
  if (farthest.near()) return met_count(numbers) + ".";
  return met_count(numbers) + "; farthest off: " + farthest.name() + " (" + farthest.tests + "), " +
         fixed(farthest.ratio(), 2) + " times it.";
}

}  // namespace encased_column
