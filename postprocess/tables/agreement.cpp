// SPDX-License-Identifier: GPL-2.0-only
#include "tables/agreement.h"

#include "tables/target_table.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace encased_column {

namespace {

/// Places in a row of target_rows(); a value and a ratio for each set of parameters follow.
struct TargetCell {
  static constexpr std::size_t set = 0, quantity = 1, unit = 2, condition = 3, laboratory = 4,
                               model = 5, first = 6;
};

bool begins_with(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

/// "plain" of plain_triaxial, "column" of column_density.
std::string kind_of_tests(const std::string& set_name)
{
  return set_name.substr(0, set_name.find('_'));
}

/// What a tile calls a quantity; empty where it does not stand there.
std::string tile_name(const std::vector<std::string>& row, bool has_line)
{
  if (begins_with(row[TargetCell::set], "column"))
    return row[TargetCell::quantity] == "porosity" ? "" : row[TargetCell::quantity];
  const std::string stress = "sigma3=";
  const std::string at = begins_with(row[TargetCell::condition], stress)
                             ? " at " + row[TargetCell::condition].substr(stress.size())
                             : "";
  if (begins_with(row[TargetCell::quantity], "secant modulus E50")) return "E50" + at;
  if (begins_with(row[TargetCell::quantity], "apparent friction angle")) return "φ";
  if (begins_with(row[TargetCell::quantity], "apparent cohesion")) return "c";
  if (begins_with(row[TargetCell::quantity], "peak deviator q") && !has_line) return "peak q" + at;
  return "";
}

/// Three digits: enough beside published values.
std::string in_three_digits(const std::string& number)
{
  const double value = std::atof(number.c_str());
  if (std::abs(value) >= 100.0) return fixed(value, 0);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

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
      const bool has_line = std::any_of(sets.begin(), sets.end(), [&](const SetResult& s) {
        return s.set == row[TargetCell::set] && s.line &&
               (!several || headings[column] == "set " + s.parameters());
      });
      const std::string name = tile_name(row, has_line);
      if (name.empty() || row[column + 1] == "-") continue;
      const bool of_laboratory = row[TargetCell::laboratory] != "-";
      numbers.push_back(
          {kind_of_tests(row[TargetCell::set]) + (several ? ", " + headings[column] : ""), name,
           row[TargetCell::unit], in_three_digits(row[column]),
           of_laboratory ? row[TargetCell::laboratory] : row[TargetCell::model],
           std::atof(row[column + 1].c_str()), of_laboratory});
    }
  return numbers;
}

std::string agreement_sentence(const std::vector<AgreementNumber>& numbers)
{
  if (numbers.empty()) return "The study tells no number of such tests.";
  const bool of_laboratory = std::all_of(numbers.begin(), numbers.end(),
                                         [](const AgreementNumber& n) { return n.of_laboratory; });
  const std::string whose = of_laboratory ? "the laboratory's" : "the study's";
  const auto near = std::count_if(numbers.begin(), numbers.end(),
                                  [](const AgreementNumber& n) { return n.near(); });
  const auto off = [](const AgreementNumber& n) {
    return std::abs(std::log(std::max(n.ratio, 1e-3)));  // 2 is as far off as 0.5
  };
  const AgreementNumber& farthest =
      *std::max_element(numbers.begin(), numbers.end(),
                        [&](const auto& a, const auto& b) { return off(a) < off(b); });
  const bool all_near = near == static_cast<long>(numbers.size()) && near > 1;
  const std::string all = std::to_string(numbers.size());
  return (all_near ? "All " + all : std::to_string(near) + " of " + all) +
         (numbers.size() == 1 ? " number" : " numbers") +
         (near == 1 || numbers.size() == 1 ? " lies" : " lie") + " within " +
         fixed(100.0 * near_laboratory, 0) + " % of " + whose +
         "; farthest off: " + farthest.quantity + " (" + farthest.tests + "), " +
         fixed(farthest.ratio, 2) + " times it.";
}

}  // namespace encased_column
