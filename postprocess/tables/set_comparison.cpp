// SPDX-License-Identifier: GPL-2.0-only
#include "tables/set_comparison.h"

#include "core/input_error.h"
#include "tables/result_table.h"

#include <algorithm>

namespace encased_column {

namespace {

/// What stands in one row: a quantity at a confining stress, or of all tests.
struct ComparedQuantity {
  std::string quantity, confining_stress;
  bool operator==(const ComparedQuantity& other) const
  {
    return quantity == other.quantity && confining_stress == other.confining_stress;
  }
};

/// The rows of one set that the study gives a value for.
struct SetColumn {
  std::string parameters;
  std::vector<std::pair<ComparedQuantity, ResultRow>> rows;
};

SetColumn set_column(const SetResult& set, const Targets& targets)
{
  SetColumn column{set.parameters(), {}};
  for (const ResultRow& row : result_rows(set, targets)) {
    if (!row.published.laboratory && !row.published.model) continue;
    std::string stress = "-";
    for (const TestResult& test : set.tests)
      if (test.run->id == row.test) stress = in_words(test.run->confining_stress / 1e3);
    column.rows.push_back({{row.quantity, stress}, row});
  }
  return column;
}

/// All keys in the order of the first column; what only others have comes behind.
std::vector<ComparedQuantity> keys_of(const std::vector<SetColumn>& columns)
{
  std::vector<ComparedQuantity> keys;
  for (const SetColumn& column : columns)
    for (const auto& [key, row] : column.rows)
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

Rows rows_of(const std::vector<SetColumn>& columns)
{
  Rows rows{{"quantity", "sigma3 [kPa]", "unit"}};
  for (const SetColumn& column : columns) {
    rows.front().push_back("set " + column.parameters);
    rows.front().push_back("to laboratory [%]");
  }
  rows.front().insert(rows.front().end(), {"laboratory", "model"});
  for (const ComparedQuantity& key : keys_of(columns)) {
    std::string unit, laboratory, model;
    std::vector<std::string> cells;
    for (const SetColumn& column : columns) {
      std::string found, difference;
      for (const auto& [other, row] : column.rows) {
        if (!(other == key)) continue;
        const std::vector<std::string> words = as_words(row);  // as result_headings
        unit = words[2];
        laboratory = words[4];
        model = words[6];
        difference = found.empty() ? words[5] : "-";  // of one run only
        found += (found.empty() ? "" : " / ") + words[3];
      }
      cells.push_back(found.empty() ? "-" : found);
      cells.push_back(found.empty() ? "-" : difference);
    }
    cells.insert(cells.begin(), {key.quantity, key.confining_stress, unit});
    cells.insert(cells.end(), {laboratory, model});
    rows.push_back(cells);
  }
  return rows;
}

}  // namespace

std::vector<SetComparison> set_comparisons(const std::vector<SetResult>& sets,
                                           const Targets& targets)
{
  std::vector<SetComparison> comparisons;
  for (const std::string kind : {"plain_triaxial", "encased_triaxial"}) {
    std::vector<SetColumn> columns;
    for (const SetResult& set : sets)
      if (set.set == kind) columns.push_back(set_column(set, targets));
    if (columns.size() < 2) continue;
    for (SetColumn& column : columns)
      if (column.parameters.empty()) column.parameters = "not named";
    const std::string name = kind == "plain_triaxial" ? "Plain" : "Encased";
    comparisons.push_back({kind,
                           name + " triaxial tests by their set of parameters; laboratory and "
                                  "model: the study's",
                           rows_of(columns)});
  }
  return comparisons;
}

std::string comparison_text(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::string text;
  for (const SetComparison& comparison : set_comparisons(sets, targets)) {
    std::vector<bool> right(comparison.rows.front().size(), true);
    right[0] = right[2] = false;
    text += comparison.caption + "\n\n" + aligned(comparison.rows, right) + '\n';
  }
  return text;
}

}  // namespace encased_column
