// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <map>
#include <string>
#include <vector>

namespace encased_column {

/// What one run of one case gave.
struct RunResult {
  std::string problem;                 ///< why it gave nothing; empty where it did
  double seconds = 0.0;                ///< it took
  std::vector<double> strain, stress;  ///< axial strain [-], deviatoric stress [Pa]
  /// Quantities by their names, SI, and `peak_p`, the mean stress [Pa] at the peak.
  std::map<std::string, double> values;

  bool good() const { return problem.empty(); }
};

/// Reads E50, peak, end of a test from its curve as `encase report` does. Throws InputError where
/// there is no peak.
RunResult result_of_curve(const std::vector<double>& strain, const std::vector<double>& stress,
                          double confining_stress);

/// The same curve with `samples` points at equal distances, enough to draw it.
void thin_curve(RunResult& result, int samples = 101);

}  // namespace encased_column
