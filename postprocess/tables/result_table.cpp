#include "tables/result_table.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "files/column_names.h"

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
  const Published published = targets.find(run.set(), "porosity", "");
  const auto add = [&](const std::string& which, double value) {
    rows.push_back({run.id, "porosity, " + which, "-", value, 4, published});
  };
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
    rows.push_back({run.id, quantity + sign, "%", -100.0 * run.history.numbers(column).back(), 2,
                    targets.find(run.set(), quantity, confining_condition(run.confining_stress))});
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

/// `words`, each once, in the order they come in.
std::vector<std::string> distinct(const std::vector<std::string>& words)
{
  std::vector<std::string> found;
  for (const std::string& word : words)
    if (std::find(found.begin(), found.end(), word) == found.end()) found.push_back(word);
  return found;
}

std::string listed(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// What the tests of `set` are called in a note.
std::string tests_of(const SetResult& set)
{
  const std::string kind = set.tests.front().run->encased() ? "encased" : "plain";
  return kind + " tests" +
         (set.parameters().empty() ? "" : " with the parameters " + set.parameters());
}

/// The resolutions of the tests, for a heading; nothing if no deck has one.
std::string resolutions(const SetResult& set)
{
  std::vector<std::string> words;
  for (const TestResult& test : set.tests)
    if (!test.run->resolution.empty()) words.push_back(test.run->resolution);
  words = distinct(words);
  if (words.empty()) return {};
  return (words.size() > 1 ? ", resolutions " : ", resolution ") + listed(words);
}

/// What `run` has for the variable `name`.
std::string value_of(const CaseRun& run, const std::string& name)
{
  for (const auto& [other, value] : run.inputs)
    if (other == name) return value;
  return "none";
}

/// "mu (0.8, 0.5)" for each variable in which the tests differ, besides sigma3 and those that
/// change only what is written.
std::vector<std::string> mixed_variables(const SetResult& set)
{
  std::vector<std::string> names, mixed;
  for (const TestResult& test : set.tests)
    for (const auto& [name, value] : test.run->inputs) names.push_back(name);
  for (const std::string& name : distinct(names)) {
    if (name == "sigma3" || name == "frames" || name == "chains" || name == "restart_every")
      continue;
    std::vector<std::string> values;
    for (const TestResult& test : set.tests) values.push_back(value_of(*test.run, name));
    values = distinct(values);
    if (values.size() > 1) mixed.push_back(name + " (" + listed(values) + ")");
  }
  return mixed;
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
                      targets.find(set.set, "secant modulus E50", condition(test))});
  for (const TestResult& test : set.tests)
    rows.push_back({test.run->id, "peak deviator q", "kPa", test.peak.reported / 1e3, 1,
                    targets.find(set.set, "peak deviator q", condition(test))});
  if (set.line) {
    const Strength strength = strength_of(*set.line);
    rows.push_back({"all", "apparent friction angle phi", "deg",
                    strength.friction_angle * 180.0 / pi, 2,
                    targets.find(set.set, "apparent friction angle", "")});
    rows.push_back({"all", "apparent cohesion c", "kPa", strength.cohesion / 1e3, 2,
                    targets.find(set.set, "apparent cohesion", "")});
  }
  for (const TestResult& test : set.tests) add_porosities(test, targets, rows);
  for (const TestResult& test : set.tests)
    if (test.grains)
      rows.push_back({test.run->id, "number of grains", "-", static_cast<double>(*test.grains), 0,
                      targets.find(set.set, "number of particles", "")});
  if (set.tests.front().run->encased())
    for (const TestResult& test : set.tests) {
      add_radial_strains(test, targets, rows);
      add_sleeve(test, rows);
    }
  return rows;
}

std::vector<std::string> test_notes(const TestResult& test)
{
  std::vector<std::string> notes;
  if (test.peak.noisy)
    notes.push_back("Peak of " + test.run->id + ": the largest average over 0.5 % strain; " +
                    "single samples reach " + fixed(test.peak.raw / 1e3, 1) + " kPa.");
  if (!test.secant_modulus)
    notes.push_back("No E50 of " + test.run->id + ": it starts shear above half of its peak.");
  if (test.peak.axial_strain >= test.axial_strain.back() - peak_averaging_width)
    notes.push_back("Peak of " + test.run->id + ": at the end of the test, " +
                    fixed(100.0 * test.axial_strain.back(), 1) +
                    " % strain; the curve may still rise.");
  return notes;
}

std::vector<std::string> result_notes(const SetResult& set)
{
  std::vector<std::string> notes;
  for (const TestResult& test : set.tests)
    for (const std::string& note : test_notes(test)) notes.push_back(note);
  const std::vector<std::string> mixed = mixed_variables(set);
  if (set.line && !mixed.empty())
    notes.push_back(
        "The line of the " + tests_of(set) +
        ", and so phi and c, mixes runs that differ in more than sigma3: " + listed(mixed) + ".");
  if (!set.line)
    notes.push_back(
        "No friction angle and cohesion of the " + tests_of(set) +
        ": they take peaks at two confining stresses at least, on a line that rises by less "
        "than 3.");
  return notes;
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
    text += std::string(first.run->encased() ? "Encased" : "Plain") + " triaxial tests";
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
