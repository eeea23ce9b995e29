// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/labels.h"

#include "core/input_error.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace encased_column {

const char* const axial_strain_title = "axial strain ε₁ [%]";

std::vector<double> scaled(const std::vector<double>& values, double factor)
{
  std::vector<double> result;
  for (const double value : values) result.push_back(factor * value);
  return result;
}

std::vector<double> percent(const std::vector<double>& shares)
{
  return scaled(shares, 100.0);
}

namespace {

using Label = std::string (*)(const TestResult&);

std::string stress_label(const TestResult& test)
{
  return "σ₃ = " + in_words(test.run->confining_stress / 1e3) + " kPa";
}

std::string gradation_label(const TestResult& test)
{
  return test.run->gradation;
}

bool differs(const std::vector<TestResult>& tests, Label label)
{
  return std::any_of(tests.begin(), tests.end(),
                     [&](const TestResult& test) { return label(test) != label(tests.front()); });
}

/// What the tests of `set` are told apart by.
std::vector<Label> telling(const SetResult& set)
{
  std::vector<Label> labels;
  const bool columns = set.set == "column";
  if (!columns || differs(set.tests, stress_label)) labels.push_back(stress_label);
  if (differs(set.tests, gradation_label)) labels.push_back(gradation_label);
  if (differs(set.tests, density_label) || labels.empty()) labels.push_back(density_label);
  return labels;
}

}  // namespace

std::string density_label(const TestResult& test)
{
  const TestDensity& density = test.density;
  if (density.relative_density) {
    const std::string porosity =
        density.laboratory_porosity ? " (n = " + fixed(*density.laboratory_porosity, 3) + ")" : "";
    return "Dr = " + fixed(100.0 * *density.relative_density, 0) + " %" + porosity;
  }
  if (test.run->generation_porosity)
    return "n = " + fixed(*test.run->generation_porosity, 3) + " at generation";
  return test.run->id;
}

std::vector<std::vector<std::string>> test_labels(const std::vector<SetResult>& sets)
{
  const auto encased = [](const SetResult& set) { return set.tests.front().run->encased(); };
  const bool both = std::any_of(sets.begin(), sets.end(), encased) &&
                    !std::all_of(sets.begin(), sets.end(), encased);
  std::vector<std::vector<std::string>> labels;
  for (const SetResult& set : sets) {
    labels.emplace_back();
    std::map<std::string, int> called;
    const std::vector<Label> telling_labels = telling(set);
    for (const TestResult& test : set.tests) {
      std::string label;
      for (const Label part : telling_labels) label += (label.empty() ? "" : ", ") + part(test);
      if (both) label += test.run->encased() ? ", encased" : ", plain";
      ++called[label];
      labels.back().push_back(label);
    }
    for (std::size_t t = 0; t < set.tests.size(); ++t)
      if (called[labels.back()[t]] > 1) labels.back()[t] = set.tests[t].run->id;
  }
  return labels;
}

std::vector<std::vector<std::size_t>> color_numbers(const std::vector<SetResult>& sets)
{
  std::map<double, std::size_t> known;
  std::size_t next = 0;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      if (known.emplace(test.run->confining_stress, next).second) ++next;
  std::vector<std::vector<std::size_t>> numbers;
  for (const SetResult& set : sets) {
    std::set<double> seen;
    numbers.emplace_back();
    for (const TestResult& test : set.tests) {
      const double sigma3 = test.run->confining_stress;
      numbers.back().push_back(seen.insert(sigma3).second ? known[sigma3] : next++);
    }
  }
  return numbers;
}

Stroke stroke_of_number(std::size_t number)
{
  static const std::array<Stroke, 3> strokes{Stroke::solid, Stroke::dashed, Stroke::dash_dotted};
  return strokes[number / palette_size % strokes.size()];
}

Stroke stroke_of(const SetResult& set, std::size_t sets, std::size_t number)
{
  if (sets > 1 && !set.tests.front().run->encased()) return Stroke::dashed;
  return stroke_of_number(number);
}

namespace {

/// Between the strains at which a test is looked at [-].
double shown_step(const TestResult& test)
{
  constexpr double of_triaxial_tests = 0.05, of_columns = 6e-3;  // [-], [m]
  constexpr double most = 8.0;                                   // curves in one chart
  if (!test.run->column()) return of_triaxial_tests;
  double step = of_columns / initial_height(test);
  while (test.axial_strain.back() > most * step) step *= 2.0;
  return step;
}

}  // namespace

double shown_tolerance(const TestResult& test)
{
  // Frames of a triaxial test are 1 % apart.
  return test.run->column() ? 0.5 * shown_step(test) : 0.01;
}

std::vector<double> shown_strains(const TestResult& test)
{
  std::vector<double> strains;
  const double step = shown_step(test);
  for (int i = 0; i * step <= test.axial_strain.back() + shown_tolerance(test); ++i)
    strains.push_back(i * step);
  return strains;
}

}  // namespace encased_column
