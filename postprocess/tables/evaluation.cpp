// SPDX-License-Identifier: GPL-2.0-only
#include "tables/evaluation.h"

#include "analysis/run_checks.h"
#include "core/input_error.h"
#include "files/column_names.h"
#include "reading/column_files.h"
#include "reading/frame_files.h"
#include "tables/outside_check.h"

#include <algorithm>

namespace encased_column {

namespace {

std::vector<double> mean_of(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> mean;
  for (std::size_t i = 0; i < a.size(); ++i) mean.push_back(0.5 * (a[i] + b[i]));
  return mean;
}

std::vector<double> deviatoric_stress(const TextTable& history, Platen platen)
{
  const ColumnName top = history_column::deviatoric_stress_top,
                   bottom = history_column::deviatoric_stress_bottom;
  if (platen == Platen::top) return history.numbers(top);
  if (platen == Platen::bottom) return history.numbers(bottom);
  return mean_of(history.numbers(top), history.numbers(bottom));
}

constexpr double gravity_of_study = 9.8;  // m/s^2, of runs from before it was a variable

/// Stress of the grains' weight at each sample [Pa]; none where the run does not know their
/// density.
std::vector<double> weight_stresses(const CaseRun& run)
{
  const std::optional<double> density = run.number("density");
  if (!density) return {};
  const double gravity = run.number("gravity").value_or(gravity_of_study);
  const std::vector<double> porosity = run.history.numbers(history_column::porosity);
  const std::vector<double> height = run.history.numbers(history_column::height);
  std::vector<double> stresses;
  for (std::size_t i = 0; i < height.size(); ++i)
    stresses.push_back(weight_stress(*density, gravity, porosity[i], height[i]));
  return stresses;
}

/// The ratio that the deck ended consolidation with; "average" where its history is older than the
/// other one, or its deck says nothing of grains that bear no load.
void take_unbalanced_ratio(const CaseRun& run, ShearRecord& record)
{
  const bool bearing =
      run.number("counts_floating") == 0.0 && run.history.has(history_column::unbalanced_bearing);
  record.unbalanced_kind = bearing ? "bearing" : "average";
  record.unbalanced_ratio = run.history.numbers(bearing ? history_column::unbalanced_bearing
                                                        : history_column::unbalanced_average);
}

ShearRecord shear_record(const CaseRun& run)
{
  ShearRecord record;
  record.target_confining_stress = run.confining_stress;
  record.axial_strain = run.history.numbers(history_column::axial_strain);
  record.confining_stress = run.history.numbers(history_column::confining_stress);
  record.stress_top = run.history.numbers(history_column::stress_top);
  record.stress_bottom = run.history.numbers(history_column::stress_bottom);
  record.weight_stress = weight_stresses(run);
  take_unbalanced_ratio(run, record);
  record.inertial_number = run.history.numbers(history_column::inertial_number);
  record.energy_error = run.history.numbers(history_column::energy_error);
  return record;
}

TestResult evaluate_run(const CaseRun& run, Platen platen, const Targets& targets)
{
  TestResult result;
  result.run = &run;
  result.platen = platen;
  result.record = shear_record(run);
  result.axial_strain = result.record.axial_strain;
  result.deviatoric_stress = deviatoric_stress(run.history, platen);
  result.volumetric_strain = run.history.numbers(history_column::volumetric_strain);

  const SampledCurve curve(result.axial_strain, result.deviatoric_stress);
  result.peak = peak_strength(curve);
  result.secant_modulus = secant_modulus(curve, result.peak.reported);
  const SampledCurve confining(result.axial_strain, result.record.confining_stress);
  const double half_width = 0.5 * peak_averaging_width;
  result.peak_stress = stress_point(
      confining.mean(result.peak.axial_strain - half_width, result.peak.axial_strain + half_width),
      result.peak.reported);
  result.checks = run_checks(result.record, !run.encased());
  const std::optional<GrainFile> grains = last_grain_file(run.folder);
  if (grains) result.grains = grains->grains;
  result.checks.push_back(outside_check(run, grains));
  result.density = test_density(run, targets);
  result.spheres = read_spheres(run);
  result.contacts = read_contacts(run);
  if (!run.encased()) return result;

  result.sleeve = read_sleeve_record(run.folder);
  result.profiles = read_sleeve_profiles(run.folder);
  const std::optional<StripLimit> strip = targets.strip_limit();
  if (result.sleeve && strip)
    for (const Check& check : sleeve_checks(*result.sleeve, *strip)) result.checks.push_back(check);
  return result;
}

bool has_two_confining_stresses(const std::vector<TestResult>& tests)
{
  for (const TestResult& test : tests)
    if (test.run->confining_stress != tests.front().run->confining_stress) return true;
  return false;
}

}  // namespace

double initial_height(const TestResult& test)
{
  return test.run->history.numbers(history_column::height).front();
}

std::string platen_name(Platen platen)
{
  if (platen == Platen::mean) return "mean of both platens";
  return platen == Platen::top ? "top platen" : "bottom platen";
}

Platen platen_of(const std::string& word)
{
  if (word == "top") return Platen::top;
  if (word == "bottom") return Platen::bottom;
  if (word == "mean") return Platen::mean;
  throw InputError("a platen must be top, bottom or mean, found '" + word +
                   "', write for example '--platen bottom'");
}

std::string tests_name(const SetResult& set)
{
  if (set.set == "column") return "columns";
  return set.tests.front().run->encased() ? "encased tests" : "plain tests";
}

std::string tests_heading(const SetResult& set)
{
  if (set.set == "column") return "Encased columns";
  return set.tests.front().run->encased() ? "Encased triaxial tests" : "Plain triaxial tests";
}

bool name_parameters(const std::vector<SetResult>& sets)
{
  return std::any_of(sets.begin(), sets.end(),
                     [](const SetResult& set) { return !set.parameters().empty(); });
}

Published published_of(const CaseRun& run, const Targets& targets, const std::string& quantity,
                       const std::string& condition)
{
  if (run.reproduces.empty()) return {};
  return targets.find(run.set(), quantity, condition);
}

bool repeats_study(const TestResult& test)
{
  return !test.run->reproduces.empty();
}

bool of_study(const SetResult& set)
{
  return std::all_of(set.tests.begin(), set.tests.end(), repeats_study);
}

std::vector<SetResult> evaluate(const std::vector<CaseRun>& runs, std::optional<Platen> platen,
                                const Targets& targets)
{
  std::vector<SetResult> sets;
  for (const CaseRun& run : runs) {
    if (sets.empty() || sets.back().set != run.set() || sets.back().parameters() != run.parameters)
      sets.push_back({run.set(), {}, {}});
    const Platen usual = run.encased() ? Platen::bottom : Platen::mean;
    try {
      sets.back().tests.push_back(evaluate_run(run, platen.value_or(usual), targets));
    } catch (const InputError& problem) {
      throw InputError("run '" + run.id + "': " + problem.what());
    }
  }
  for (SetResult& set : sets) {
    if (!has_two_confining_stresses(set.tests)) continue;
    std::vector<StressPoint> peaks;
    for (const TestResult& test : set.tests) peaks.push_back(test.peak_stress);
    const FailureLine line = fit_failure_line(peaks);
    // Tests that stopped early can have peaks on a line that no friction angle has.
    if (line.slope >= 0.0 && line.slope < 3.0) set.line = line;
  }
  return sets;
}

}  // namespace encased_column
