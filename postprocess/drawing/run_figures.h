#pragma once

#include "drawing/figure.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

/// How well the runs went: unbalanced ratio, inertial number, platen difference of plain tests,
/// over axial strain.
Figure check_figure(const std::vector<SetResult>& sets);

/// energy_<id>: where the work of each test went.
std::vector<Figure> energy_figures(const std::vector<SetResult>& sets);

}  // namespace encased_column
