// SPDX-License-Identifier: GPL-2.0-only
#include "tables/result_sentences.h"

#include "core/input_error.h"
#include "tables/check_table.h"
#include "tables/result_table.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

/// A quantity of which the laboratory has a value.
struct Comparison {
  std::string quantity;  ///< in short
  std::string of;        ///< a test, or "the plain tests"
  const ResultRow row;
  bool met;
};

/// "peak q" of "peak deviator q", what stands before a comma of others.
std::string in_short(const std::string& quantity)
{
  const std::pair<const char*, const char*> names[] = {
      {"secant modulus E50", "E50"},
      {"peak deviator q", "peak q"},
      {"apparent friction angle", "friction angle"},
      {"apparent cohesion", "cohesion"}};
  for (const auto& [long_name, name] : names)
    if (quantity.rfind(long_name, 0) == 0) return name;
  return quantity.substr(0, quantity.find(','));
}

/// What cohesion may be off in `set` [kPa].
double cohesion_allowance_of(const SetResult& set, const std::vector<ResultRow>& rows,
                             const Targets& targets)
{
  const auto strength = targets.strength(set.set, true);
  double smallest = std::numeric_limits<double>::infinity();
  for (const ResultRow& row : rows)
    if (in_short(row.quantity) == "peak q" && row.published.laboratory)
      smallest = std::min(smallest, *row.published.laboratory);
  if (!strength || !std::isfinite(smallest)) return 0.0;
  return cohesion_allowance(smallest, strength->friction_angle);
}

std::vector<Comparison> comparisons(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::vector<Comparison> found;
  for (const SetResult& set : sets) {
    const std::vector<ResultRow> rows = result_rows(set, targets);
    const std::string all =
        "the " + tests_name(set) + (set.parameters().empty() ? "" : " (" + set.parameters() + ")");
    for (const ResultRow& row : rows) {
      if (!row.published.laboratory) continue;
      const std::string quantity = in_short(row.quantity), of = row.test == "all" ? all : row.test;
      const bool again = std::any_of(found.begin(), found.end(), [&](const Comparison& other) {
        return other.quantity == quantity && other.of == of;  // a porosity counted in two ways
      });
      if (again) continue;
      const double laboratory = *row.published.laboratory;
      double allowed = near_laboratory * std::abs(laboratory);
      if (quantity == "cohesion")
        allowed = std::max(allowed, cohesion_allowance_of(set, rows, targets));
      found.push_back({quantity, of, row, std::abs(row.value - laboratory) <= allowed});
    }
  }
  return found;
}

/// "peak q 6 of 6, E50 3 of 4", in the order of the table.
std::string counts_by_quantity(const std::vector<Comparison>& all)
{
  std::vector<std::string> quantities;
  for (const Comparison& one : all)
    if (std::find(quantities.begin(), quantities.end(), one.quantity) == quantities.end())
      quantities.push_back(one.quantity);
  std::string text;
  for (const std::string& quantity : quantities) {
    long met = 0, number = 0;
    for (const Comparison& one : all)
      if (one.quantity == quantity) {
        ++number;
        met += one.met;
      }
    text += (text.empty() ? "" : ", ") + quantity + " " + std::to_string(met) + " of " +
            std::to_string(number);
  }
  return text;
}

/// The first few of `parts`, and how many more there are.
std::string some_of(const std::vector<std::string>& parts, const std::string& file)
{
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t n = 0; n < std::min(parts.size(), most); ++n) text += (n ? "; " : "") + parts[n];
  if (parts.size() > most)
    text += "; and " + std::to_string(parts.size() - most) + " more, in " + file;
  return text;
}

std::string percent(double part)
{
  return (part < 0.0 ? "-" : "+") + fixed(100.0 * std::abs(part), 0) + " %";
}

std::string sentences_of_values(const std::vector<Comparison>& all)
{
  if (all.empty()) return "The laboratory has no values beside which these tests could stand.\n";
  std::vector<std::string> missed;
  for (const Comparison& one : all)
    if (!one.met) {
      const double laboratory = *one.row.published.laboratory;
      missed.push_back(one.quantity + " of " + one.of + " " +
                       fixed(one.row.value, one.row.decimals) + " for " + in_words(laboratory) +
                       (one.row.unit == "-" ? "" : " " + one.row.unit) + " (" +
                       percent(one.row.value / laboratory - 1.0) + ")");
    }
  return "Met within " + fixed(100.0 * near_laboratory, 0) +
         " % of the laboratory: " + std::to_string(all.size() - missed.size()) + " of " +
         std::to_string(all.size()) + " values (" + counts_by_quantity(all) + ").\n" +
         (missed.empty() ? "Not met: none.\n" : "Not met: " + some_of(missed, "table.txt") + ".\n");
}

std::string sentence_of_checks(const std::vector<SetResult>& sets)
{
  const CheckCount count = count_checks(sets);
  std::vector<std::string> missed;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks)
        if (check.required && check.missed()) missed.push_back(test.run->id + " " + check.name);
  const std::string number = std::to_string(count.required);
  std::string text = missed.empty()
                         ? "Checks of the runs: none of " + number + " missed"
                         : "Checks of the runs: " + std::to_string(missed.size()) + " of " +
                               number + " missed (" + some_of(missed, "checks.txt") + ")";
  if (count.not_made) text += ", " + std::to_string(count.not_made) + " not made";
  return text + ".\n";
}

}  // namespace

double cohesion_allowance(double smallest_peak, double friction_angle)
{
  return near_laboratory * smallest_peak * (1.0 - std::sin(friction_angle)) /
         (2.0 * std::cos(friction_angle));
}

std::string result_sentences(const std::vector<SetResult>& sets, const Targets& targets)
{
  return sentences_of_values(comparisons(sets, targets)) + sentence_of_checks(sets);
}

}  // namespace encased_column
