#pragma once

#include "drawing/figure.h"
#include "reading/targets.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

/// How the load went in, one curve for each test: pressure_displacement, the pressure on each
/// platen over the displacement, and stress_path, q over p at the boundary and of the grains in the
/// middle third, with the published failure lines.
std::vector<Figure> load_figures(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
