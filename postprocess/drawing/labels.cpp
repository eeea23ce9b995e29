#include "drawing/labels.h"

#include "core/input_error.h"

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

std::vector<std::vector<std::string>> test_labels(const std::vector<SetResult>& sets)
{
  std::vector<std::vector<std::string>> labels;
  for (const SetResult& set : sets) {
    std::map<double, int> runs_at;
    for (const TestResult& test : set.tests) ++runs_at[test.run->confining_stress];
    labels.emplace_back();
    for (const TestResult& test : set.tests) {
      const double sigma3 = test.run->confining_stress;
      std::string label = "σ₃ = " + in_words(sigma3 / 1e3) + " kPa";
      if (sets.size() > 1) label += test.run->encased() ? ", encased" : ", plain";
      if (runs_at[sigma3] > 1) label = test.run->id;
      labels.back().push_back(label);
    }
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

}  // namespace encased_column
