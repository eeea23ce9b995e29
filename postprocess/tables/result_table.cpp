// SPDX-License-Identifier: GPL-2.0-only
#include "tables/result_table.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "files/column_names.h"
#include "tables/result_notes.h"

#include <algorithm>
#include <optional>

namespace encased_column {

namespace {

std::string difference(double value, const std::optional<double>& published)
{
  if (!published || *published == 0.0) return "-";
  const double percent = 100.0 * (value / *published - 1.0);
  return (percent >= 0.0 ? "+" : "") + fixed(percent, 1);
}

std::string optional_text(const std::optional<double>& value)
{
  return value ? in_words(*value) : "-";
}

/// The porosities a run knows; the study gives one, of the sample as prepared in the laboratory.
void add_porosities(const TestResult& test, const Targets& targets, std::vector<ResultRow>& rows)
{
  const CaseRun& run = *test.run;
  const Published published = published_of(run, targets, "porosity", "");
  const auto add = [&](const std::string& which, double value) {
    rows.push_back({run.id, "porosity, " + which, "-", value, 4, published});
  };
  if (test.density.relative_density)
    rows.push_back({run.id,
                    "relative density of the sample in the laboratory",
                    "%",
                    100.0 * *test.density.relative_density,
                    1,
                    {}});
  if (test.density.laboratory_porosity)
    rows.push_back({run.id,
                    "porosity, of the sample in the laboratory",
                    "-",
                    *test.density.laboratory_porosity,
                    4,
                    {}});
  if (run.generation_porosity)
    rows.push_back({run.id, "porosity, at generation", "-", *run.generation_porosity, 4, {}});
  add("at start of shear, overlap counted", run.history.numbers(history_column::porosity).front());
  add("at start of shear, less overlap",
      run.history.numbers(history_column::porosity_less_overlap).front());
}

void add_radial_strains(const TestResult& test, const Targets& targets,
                        std::vector<ResultRow>& rows)
{
  const CaseRun& run = *test.run;
  for (const auto& [height, column] : {std::pair("25", history_column::radial_strain_25),
                                       std::pair("50", history_column::radial_strain_50),
                                       std::pair("75", history_column::radial_strain_75)}) {
    const std::string quantity =
        std::string("radial strain at 0.") + height + "H at the end of the test";
    const std::string sign = ", from the bottom, expansion +";
    // Histories count the radius getting shorter as positive, the study its expansion.
    rows.push_back(
        {run.id, quantity + sign, "%", -100.0 * run.history.numbers(column).back(), 2,
         published_of(run, targets, quantity, confining_condition(run.confining_stress))});
  }
}

void add_sleeve(const TestResult& test, std::vector<ResultRow>& rows)
{
  if (!test.sleeve) return;
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  rows.push_back({test.run->id,
                  "hoop tension, largest",
                  "kN/m",
                  largest(test.sleeve->hoop_tension_max) / 1e3,
                  2,
                  {}});
  rows.push_back({test.run->id,
                  "hoop tension, largest mean",
                  "kN/m",
                  largest(test.sleeve->hoop_tension_mean) / 1e3,
                  2,
                  {}});
}

}  // namespace

const std::vector<std::string> result_headings{
    "test", "quantity", "unit", "found", "laboratory", "difference [%]", "model", "difference [%]"};

std::vector<std::string> as_words(const ResultRow& row)
{
  return {row.test,
          row.quantity,
          row.unit,
          fixed(row.value, row.decimals),
          optional_text(row.published.laboratory),
          difference(row.value, row.published.laboratory),
          optional_text(row.published.model),
          difference(row.value, row.published.model)};
}

std::vector<ResultRow> result_rows(const SetResult& set, const Targets& targets)
{
  std::vector<ResultRow> rows;
  const auto condition = [](const TestResult& test) {
    return confining_condition(test.run->confining_stress);
  };
  for (const TestResult& test : set.tests)
    if (test.secant_modulus)
      rows.push_back({test.run->id, "secant modulus E50", "MPa", *test.secant_modulus / 1e6, 2,
                      published_of(*test.run, targets, "secant modulus E50", condition(test))});
  for (const TestResult& test : set.tests)
    rows.push_back({test.run->id, "peak deviator q", "kPa", test.peak.reported / 1e3, 1,
                    published_of(*test.run, targets, "peak deviator q", condition(test))});
  if (set.line) {
    const Strength strength = strength_of(*set.line);
    const auto published = [&](const char* quantity) {
      return of_study(set) ? targets.find(set.set, quantity, "") : Published{};
    };
    rows.push_back({"all", "apparent friction angle phi", "deg",
                    strength.friction_angle * 180.0 / pi, 2, published("apparent friction angle")});
    rows.push_back({"all", "apparent cohesion c", "kPa", strength.cohesion / 1e3, 2,
                    published("apparent cohesion")});
  }
  for (const TestResult& test : set.tests) add_porosities(test, targets, rows);
  for (const TestResult& test : set.tests)
    if (test.grains)
      rows.push_back({test.run->id, "number of grains", "-", static_cast<double>(*test.grains), 0,
                      published_of(*test.run, targets, "number of particles", "")});
  if (set.tests.front().run->encased())
    for (const TestResult& test : set.tests) {
      add_radial_strains(test, targets, rows);
      add_sleeve(test, rows);
    }
  return rows;
}

std::string result_csv(const std::vector<SetResult>& sets, const Targets& targets)
{
  Rows rows{{"set", "test", "quantity", "unit", "found", "laboratory",
             "difference to laboratory [%]", "model", "difference to model [%]"}};
  const bool named = name_parameters(sets);
  if (named) rows.front().insert(rows.front().begin() + 1, "parameters");
  for (const SetResult& set : sets)
    for (const ResultRow& row : result_rows(set, targets)) {
      std::vector<std::string> words = as_words(row);
      for (std::string& word : words)
        if (word == "-" && &word != &words[2]) word.clear();
      if (named) words.insert(words.begin(), set.parameters());
      words.insert(words.begin(), set.set);
      rows.push_back(words);
    }
  return comma_separated(rows);
}

std::string result_text(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::string text;
  for (const SetResult& set : sets) {
    const TestResult& first = set.tests.front();
    text += (text.empty() ? "" : "\n");
    text += tests_heading(set);
    if (!set.parameters().empty()) text += ", parameters " + set.parameters();
    text += resolutions(set);
    text += ", q from the " + platen_name(first.platen) + "; laboratory and model: the study's\n\n";
    Rows rows{result_headings};
    for (const ResultRow& row : result_rows(set, targets)) rows.push_back(as_words(row));
    text += aligned(rows, {false, false, false, true, true, true, true, true});
    for (const std::string& note : result_notes(set)) text += note + '\n';
  }
  return text;
}

}  // namespace encased_column
