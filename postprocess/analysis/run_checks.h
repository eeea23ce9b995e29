#pragma once

#include "analysis/sampled_curve.h"

#include <string>
#include <vector>

namespace encased_column {

/// Width [-] of axial strain over which a check averages.
constexpr double check_averaging_width = 0.01;

/// What the checks of one test look at; all samples of the shear stage, in order.
struct ShearRecord {
  double target_confining_stress;          ///< sigma3 the servo holds [Pa]
  std::vector<double> axial_strain;        ///< [-]
  std::vector<double> confining_stress;    ///< [Pa]
  std::vector<double> stress_top;          ///< [Pa]
  std::vector<double> stress_bottom;       ///< [Pa]
  std::vector<double> weight_stress;       ///< of the grains [Pa]; empty where it is not known
  std::vector<double> unbalanced_average;  ///< mean unbalanced over mean contact force [-]
  std::vector<double> inertial_number;     ///< [-]
  std::vector<double> energy_error;        ///< share of the work put in that is not found again [-]
};

/// One check: what was found, what is allowed, and whether it is a requirement of this test.
struct Check {
  std::string name;
  double found;      ///< [-]
  double allowed;    ///< [-]
  bool required;     ///< false: told for information
  bool made = true;  ///< false: something it takes is missing; the name says what
  bool passed() const { return made && found <= allowed; }
  bool missed() const { return made && !(found <= allowed); }
};

/// Largest share [-] by which the two platens' stresses differ, averaged over windows of
/// `check_averaging_width`, relative to the mean of both, at least to the confining stress. The
/// upper one's stress counts with the weight of the grains on it; where that is not known, alone.
double platen_difference(const ShearRecord& record);

/// The same at each sample, not averaged, signed: positive where the top carries more.
std::vector<double> platen_differences(const ShearRecord& record);

/// All checks of one test. The platens need not agree where a sleeve takes load
/// (`platens_must_agree` false). Throws InputError where the record is too short to check.
std::vector<Check> run_checks(const ShearRecord& record, bool platens_must_agree);

}  // namespace encased_column
