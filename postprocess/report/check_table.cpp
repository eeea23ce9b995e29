#include "report/check_table.h"

#include "core/input_error.h"
#include "report/text_layout.h"

namespace encased_column {

namespace {

std::string verdict(const Check& check)
{
  if (check.passed()) return "pass";
  return check.required ? "FAIL" : "not required";
}

Rows check_rows(const std::vector<SetResult>& sets)
{
  Rows rows{{"test", "check", "found", "allowed", "verdict"}};
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks) {
        char found[32];
        std::snprintf(found, sizeof found, "%.3g", check.found);
        rows.push_back({test.run->id, check.name, found, in_words(check.allowed), verdict(check)});
      }
  return rows;
}

}  // namespace

std::string check_text(const std::vector<SetResult>& sets)
{
  int failed = 0, required = 0;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks) {
        required += check.required;
        failed += check.required && !check.passed();
      }
  return aligned(check_rows(sets), {false, false, true, true, false}) +
         (failed == 0
              ? "All " + std::to_string(required) + " checks passed.\n"
              : std::to_string(failed) + " of " + std::to_string(required) + " checks FAILED.\n");
}

std::string check_csv(const std::vector<SetResult>& sets)
{
  return comma_separated(check_rows(sets));
}

}  // namespace encased_column
