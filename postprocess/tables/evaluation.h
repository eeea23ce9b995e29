// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/inside_specimen.h"
#include "analysis/sleeve_record.h"
#include "analysis/strength.h"
#include "reading/case_run.h"
#include "reading/targets.h"
#include "tables/test_density.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// Which platen's stress makes the deviatoric stress.
enum class Platen { top, bottom, mean };

std::string platen_name(Platen platen);

/// The platen called `word`: top, bottom or mean.
Platen platen_of(const std::string& word);

/// What one run gave.
struct TestResult {
  const CaseRun* run;
  Platen platen;
  std::vector<double> axial_strain;       ///< [-]
  std::vector<double> deviatoric_stress;  ///< of `platen` [Pa]
  std::vector<double> volumetric_strain;  ///< [-]
  PeakStrength peak;
  std::optional<double> secant_modulus;  ///< E50 [Pa]
  StressPoint peak_stress;               ///< with the confining stress measured at the peak
  ShearRecord record;
  std::vector<Check> checks;
  std::optional<long> grains;
  TestDensity density;
  std::optional<SleeveRecord> sleeve;   ///< of encased tests that wrote one
  std::vector<SleeveProfile> profiles;  ///< the same
  std::vector<SphereSeries> spheres;    ///< from the bottom; none if the run wrote none
  std::vector<ContactSample> contacts;  ///< the same
};

/// Height [m] of the specimen at the start of shear.
double initial_height(const TestResult& test);

/// What the runs of one kind, made with one set of parameters, gave together.
struct SetResult {
  std::string set;  ///< as in targets.csv
  std::vector<TestResult> tests;
  std::optional<FailureLine>
      line;  ///< if two confining stresses at least give a slope from 0 up to 3

  /// The set of parameters its runs were made with; empty if they do not say.
  const std::string& parameters() const { return tests.front().run->parameters; }
};

/// True if a run of `sets` says which set of parameters it was made with.
bool name_parameters(const std::vector<SetResult>& sets);

/// What the study gives for a quantity of `run`, as Targets::find() has it; nothing where the run
/// reproduces nothing of the study.
Published published_of(const CaseRun& run, const Targets& targets, const std::string& quantity,
                       const std::string& condition);

/// True if `test` reproduces something of the study, so that its values may stand beside it.
bool repeats_study(const TestResult& test);

/// True if all tests of `set` reproduce something of the study, whose values are then the ones
/// their common line may stand beside; a deck of one's own reproduces nothing.
bool of_study(const SetResult& set);

/// Evaluates all runs, plain and encased ones and each set of parameters by itself. Without
/// `platen`, plain tests use the mean of both platens and encased ones the bottom: the sleeve takes
/// load, and the study read its base wall. The results refer to `runs`. The sleeve is checked
/// against the strip test of `targets`, and densities are those of its Table 6. Throws InputError,
/// naming the run, where a history cannot be evaluated.
std::vector<SetResult> evaluate(const std::vector<CaseRun>& runs, std::optional<Platen> platen,
                                const Targets& targets);

/// "plain tests", "encased tests" or "columns".
std::string tests_name(const SetResult& set);

/// The same as a heading: "Plain triaxial tests".
std::string tests_heading(const SetResult& set);

}  // namespace encased_column
