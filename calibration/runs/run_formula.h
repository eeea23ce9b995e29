// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runs/run_program.h"

namespace encased_column {

/// A closed form in place of a plain triaxial test, to try a calibration out in seconds: of
/// `modulus` [Pa], `kappa`, `mu`, `mu_r`, `sigma3` [Pa] and `seed`. It has the shape of such tests
/// and the scatter of packings (2 % of E50, 1 % of the strength, both normal), but no test behind
/// it:
///
///   E50 = 0.08 E* (sigma3 / 100 kPa)^0.4 / (0.85 + 0.15 kappa)
///   phi = 18 deg + 20 deg (1 - exp(-2.5 mu)) + 6 deg mu_r / (0.3 + mu_r)
///   end / peak = 1 - 0.35 exp(-4 mu_r) (0.4 + mu)
///
/// q rises to the peak at 10 % as 1 - 2^(-strain / strain of E50) and falls in a straight line to
/// the end at 20 %.
RunResult run_formula(const PlannedRun& run);

}  // namespace encased_column
