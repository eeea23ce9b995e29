#pragma once

#include "drawing/figure.h"
#include "reading/targets.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

/// What only encased tests have, a panel for each test: radial_strain (at three heights, with the
/// study's end values), platens (q of both, with the closed form), radial_profile (along the
/// height) and hoop_tension (mean and largest, with the limit of the strip test); and
/// radial_expansion, along the height of all tests at the study's 12 and 24 mm of displacement.
/// Leaves out what the runs did not write; nothing without encased tests.
std::vector<Figure> sleeve_figures(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
