// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/case_run.h"

#include <vector>

namespace encased_column {

/// Hoop tension [N/m] over strain [-] of a sleeve's material, from zero on.
struct StripTable {
  std::vector<double> strain, hoop_tension;
};

/// The strip tests that the sleeve of `run` was made with: the table that its variable `strip`
/// names, or the line of `modulus_sleeve` times `thickness` up to `strength`. Empty for plain tests
/// and where case.json does not say. Throws InputError if the table cannot be read.
StripTable strip_table(const CaseRun& run);

}  // namespace encased_column
