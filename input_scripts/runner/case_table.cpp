// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_table.h"

#include "core/input_error.h"
#include "runner/aligned_text.h"
#include "runner/text_file.h"

#include <algorithm>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// The checks that `id` missed; none where there is no such table.
std::vector<std::string> missed_checks(const std::string& id, const fs::path& file)
{
  std::vector<std::string> missed;
  if (!fs::exists(file)) return missed;
  const auto rows = csv_rows(read_text_file(file, "'" + shown(file) + "'"), shown(file));
  if (rows.empty()) return missed;
  const auto place = [&](const std::string& column) -> std::size_t {
    const auto& names = rows.front();
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end())
      throw InputError("'" + shown(file) + "' must have a column '" + column +
                       "', found none, make it again with `encase report`");
    return found - names.begin();
  };
  const std::size_t test = place("test"), check = place("check"), found = place("found"),
                    allowed = place("allowed"), verdict = place("verdict");
  for (const auto& row : rows)
    if (row.size() == rows.front().size() && row[test] == id && row[verdict] == "FAIL")
      missed.push_back(row[check] + ": " + row[found] + ", allowed " + row[allowed]);
  return missed;
}

}  // namespace

std::string case_table(const std::vector<CaseOutcome>& outcomes)
{
  std::vector<std::vector<std::string>> rows{{"case", "outcome", "why"}};
  for (const CaseOutcome& one : outcomes) rows.push_back({one.id, one.outcome, one.why});
  const auto passed = std::count_if(outcomes.begin(), outcomes.end(),
                                    [](const CaseOutcome& one) { return one.outcome == "passed"; });
  return aligned(rows) + std::to_string(passed) + " of " + std::to_string(outcomes.size()) +
         " passed.\n";
}

CaseOutcome outcome_of(const CaseFolder& folder, const fs::path& checks_file)
{
  const FolderState state = folder.state();
  if (state.finished) {
    const std::vector<std::string> missed = missed_checks(folder.id(), checks_file);
    if (missed.empty()) return {folder.id(), "passed", ""};
    std::string why;
    for (const std::string& check : missed) why += (why.empty() ? "" : "; ") + check;
    return {folder.id(), "checks missed", why};
  }
  if (!state.failed.empty()) return {folder.id(), "failed", state.failed};
  if (!state.begun) return {folder.id(), "not run", ""};
  const Progress progress = folder.progress();
  return {folder.id(), "stopped",
          "in " + progress.stage + ", at " +
              std::to_string(static_cast<int>(100.0 * progress.fraction)) + " %"};
}

}  // namespace encased_column
