// SPDX-License-Identifier: GPL-2.0-only
#include "tables/check_table.h"

#include "core/input_error.h"
#include "tables/text_layout.h"

namespace encased_column {

namespace {

std::string verdict(const Check& check)
{
  if (!check.made) return "not made";
  if (check.passed()) return "pass";
  return check.required ? "FAIL" : "not required";
}

}  // namespace

Rows check_rows(const std::vector<SetResult>& sets)
{
  Rows rows{{"test", "check", "found", "allowed", "verdict"}};
  const bool named = name_parameters(sets);
  if (named) rows.front().insert(rows.front().begin() + 1, "parameters");
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks) {
        char found[32] = "-";
        if (check.made) std::snprintf(found, sizeof found, "%.3g", check.found);
        rows.push_back({test.run->id, check.name, found, in_words(check.allowed), verdict(check)});
        if (named) rows.back().insert(rows.back().begin() + 1, set.parameters());
      }
  return rows;
}

std::string CheckCount::sentence() const
{
  std::string text = std::to_string(failed) + " of " + std::to_string(required) + " checks missed";
  if (not_made > 0) text += ", " + std::to_string(not_made) + " not made";
  return text + '.';
}

CheckCount count_checks(const std::vector<SetResult>& sets)
{
  CheckCount count;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks) {
        count.required += check.required;
        count.failed += check.required && check.missed();
        count.not_made += check.required && !check.made;
      }
  return count;
}

std::string check_text(const std::vector<SetResult>& sets)
{
  std::vector<bool> right{false, false, true, true, false};
  if (name_parameters(sets)) right.insert(right.begin(), false);
  return aligned(check_rows(sets), right) + count_checks(sets).sentence() + '\n';
}

std::string check_csv(const std::vector<SetResult>& sets)
{
  return comma_separated(check_rows(sets));
}

}  // namespace encased_column
