// SPDX-License-Identifier: GPL-2.0-only
#include "tables/result_notes.h"

#include "core/input_error.h"
#include "tables/text_layout.h"

#include <algorithm>

namespace encased_column {

namespace {

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
  return tests_name(set) +
         (set.parameters().empty() ? "" : " with the parameters " + set.parameters());
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

std::string resolutions(const SetResult& set)
{
  std::vector<std::string> words;
  for (const TestResult& test : set.tests)
    if (!test.run->resolution.empty()) words.push_back(test.run->resolution);
  words = distinct(words);
  if (words.empty()) return {};
  return (words.size() > 1 ? ", resolutions " : ", resolution ") + listed(words);
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
  if (!set.line && set.set != "column")
    notes.push_back(
        "No friction angle and cohesion of the " + tests_of(set) +
        ": they take peaks at two confining stresses at least, on a line that rises by less "
        "than 3.");
  return notes;
}

}  // namespace encased_column
