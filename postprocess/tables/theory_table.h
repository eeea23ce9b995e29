// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// An encased test at one axial strain, and what it should bear by the closed form; every value is
/// the mean over `peak_averaging_width` of axial strain.
struct SleeveState {
  double axial_strain;       ///< [-]
  double q_top, q_bottom;    ///< at the platens [Pa]
  double hoop_tension;       ///< mean of the sleeve [N/m]
  double radius;             ///< mean of the sleeve, from its hoop strain [m]
  double extra_confinement;  ///< hoop tension over radius [Pa]
  double friction_share;     ///< of the larger platen force that goes into the sleeve [-]
  std::optional<double> friction_angle;  ///< mobilised in the middle third [rad]
  std::optional<double> q_theory;        ///< see encased_deviatoric_stress() [Pa]
};

/// `test` at `axial_strain`. Nothing if the test did not get there or has no sleeve record; no
/// theory if its history has no stress of the middle third.
std::optional<SleeveState> sleeve_state(const TestResult& test, double axial_strain);

/// Headings, and a row for each encased test and strain; only the headings if no encased test wrote
/// a sleeve record.
Rows theory_rows(const std::vector<SetResult>& sets);

/// Both platens of the encased tests beside the closed form, at 5, 10, 15 and 20 % axial strain as
/// far as a test went, for reading; empty if no encased test wrote a sleeve record.
std::string theory_text(const std::vector<SetResult>& sets);

/// The same as CSV.
std::string theory_csv(const std::vector<SetResult>& sets);

}  // namespace encased_column
