// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/case_run.h"
#include "reading/targets.h"

#include <optional>

namespace encased_column {

/// How dense the sample of the laboratory is that a run stands for.
struct TestDensity {
  std::optional<double> relative_density;     ///< [-]
  std::optional<double> laboratory_porosity;  ///< of the sample as prepared [-]
};

/// Of `run`: its deck's `relative_density` where that was set. Else its `sample_porosity`, that of
/// the tests (0.40) where the deck has none. What a set of parameters has by itself as `porosity`
/// stands for that sample (the study's model was generated at 0.20), and what a run asks for beyond
/// it is added. Relative densities and porosities are those of Table 6; nothing
/// where a run does not say enough or lies beyond that table.
TestDensity test_density(const CaseRun& run, const Targets& targets);

}  // namespace encased_column
