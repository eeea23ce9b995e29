// SPDX-License-Identifier: GPL-2.0-only
#include "tables/target_table.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "tables/target_record.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace encased_column {

namespace {

/// What a value in SI units is multiplied by to stand in `unit`.
double to_unit(const std::string& unit)
{
  static const std::array<std::pair<const char*, double>, 9> factors{{{"-", 1.0},
                                                                      {"%", 1e2},
                                                                      {"Pa", 1.0},
                                                                      {"kPa", 1e-3},
                                                                      {"MPa", 1e-6},
                                                                      {"deg", 180.0 / pi},
                                                                      {"kN/m", 1e-3},
                                                                      {"mm", 1e3},
                                                                      {"N", 1.0}}};
  for (const auto& [name, factor] : factors)
    if (unit == name) return factor;
  return 1.0;  // diameters
}

const TargetValue* value_of(const TargetRow& row)
{
  const auto starts = [](const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
  };
  for (const TargetValue& value : target_values())
    if (starts(row.quantity, value.quantity) && starts(row.condition, value.condition))
      return &value;
  return nullptr;
}

/// A test that was run, ready to be asked.
struct ReadTest {
  const TestResult* test;
  TargetRecord record;
  TestCondition condition;
};

/// The tests made with one set of parameters.
struct ParameterColumn {
  std::string parameters;
  std::vector<ReadTest> tests;
};

std::vector<ParameterColumn> columns_of(const std::vector<SetResult>& sets)
{
  std::vector<ParameterColumn> columns;
  for (const SetResult& set : sets) {
    auto column = std::find_if(columns.begin(), columns.end(), [&](const ParameterColumn& c) {
      return c.parameters == set.parameters();
    });
    if (column == columns.end()) column = columns.insert(column, {set.parameters(), {}});
    for (const TestResult& test : set.tests)
      column->tests.push_back({&test, target_record(set, test), test_condition(test)});
  }
  return columns;
}

/// "column_density" is of columns, the geotextile's rows of all that have a sleeve; none is of a
/// run that reproduces nothing of the study.
bool of_set(const ReadTest& read, const TargetRow& row)
{
  const CaseRun& run = *read.test->run;
  if (run.reproduces.empty()) return false;
  if (row.set == "geotextile") return run.encased();
  return row.set == run.set() || row.set.rfind(run.set() + "_", 0) == 0;
}

/// What the runs of one set of parameters say about a row.
struct FoundValue {
  std::vector<std::string> runs;  ///< that are of the row's test
  std::optional<double> value;    ///< mean of those that tell, in the row's unit
};

FoundValue found_value(const ParameterColumn& column, const TargetRow& row,
                       std::optional<double> usual_density)
{
  FoundValue found;
  const TargetValue* how = value_of(row);
  const TargetCondition words = row.words();
  double sum = 0.0;
  int told = 0;
  for (const ReadTest& read : column.tests) {
    if (!of_set(read, row) || !meets(read.condition, words, usual_density)) continue;
    found.runs.push_back(read.test->run->id);
    const std::optional<double> value = how ? how->value(read.record, words) : std::nullopt;
    if (!value) continue;
    sum += *value * to_unit(row.unit);
    ++told;
  }
  if (told > 0) found.value = sum / told;
  return found;
}

/// Four digits, as many as the study prints.
std::string in_digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return std::abs(value) >= 1e4 ? fixed(value, 0) : text;
}

std::string published_word(const std::optional<double>& value)
{
  return value ? in_words(*value) : "-";
}

std::string found_word(const FoundValue& found)
{
  if (found.value) return in_digits(*found.value);
  return found.runs.empty() ? "not run" : "not told";
}

std::string ratio_word(const FoundValue& found, const Published& published)
{
  const std::optional<double> to = published.laboratory ? published.laboratory : published.model;
  if (!found.value || !to || *to == 0.0) return "-";
  return fixed(*found.value / *to, 2);
}

/// A quantity without what stands in brackets behind it for readers of the file.
std::string shortened(const std::string& quantity)
{
  return quantity.substr(0, quantity.find(" (reading"));
}

std::string in_list(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text.empty() ? "-" : text;
}

Rows rows_with(const std::vector<SetResult>& sets, const Targets& targets, bool complete)
{
  const std::vector<ParameterColumn> columns = columns_of(sets);
  const auto sample = targets.find("plain_triaxial", "porosity", "prepared sample").laboratory;
  const std::optional<double> usual_density =
      sample ? relative_density_at(*sample, targets.densities()) : std::nullopt;

  Rows rows{{"set", "quantity", "unit", "condition", "laboratory", "model"}};
  for (const ParameterColumn& column : columns) {
    const std::string name = column.parameters.empty() ? "found" : "set " + column.parameters;
    rows.front().push_back(name);
    rows.front().push_back(columns.size() > 1 ? "ratio " + column.parameters : "ratio");
    if (complete) rows.front().push_back("runs of " + name);
  }
  if (complete) rows.front().push_back("source");
  for (const TargetRow& row : targets.all()) {
    rows.push_back({row.set, shortened(row.quantity), row.unit,
                    row.condition.empty() ? "-" : row.condition,
                    published_word(row.published.laboratory), published_word(row.published.model)});
    for (const ParameterColumn& column : columns) {
      const FoundValue found = found_value(column, row, usual_density);
      rows.back().push_back(found_word(found));
      rows.back().push_back(ratio_word(found, row.published));
      if (complete) rows.back().push_back(in_list(found.runs));
    }
    if (complete) rows.back().push_back(row.source);
  }
  return rows;
}

}  // namespace

Rows target_rows(const std::vector<SetResult>& sets, const Targets& targets)
{
  return rows_with(sets, targets, false);
}

std::string target_text(const std::vector<SetResult>& sets, const Targets& targets)
{
  const Rows rows = target_rows(sets, targets);
  std::vector<bool> right(rows.front().size(), true);
  std::fill(right.begin(), right.begin() + 4, false);
  return "All values of the study; ratio: to the laboratory's, to the model's where there is "
         "none\n\n" +
         aligned(rows, right) +
         "Pressure and q: of the platen that table.txt names. not run: no run is of that test; not "
         "told: it did not go so far or did not write it. Means where several runs are of one "
         "test; beside_study.csv names them.\n";
}

std::string target_csv(const std::vector<SetResult>& sets, const Targets& targets)
{
  return comma_separated(rows_with(sets, targets, true));
}

}  // namespace encased_column
