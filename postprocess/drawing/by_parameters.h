// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "drawing/figure.h"
#include "tables/evaluation.h"

#include <functional>
#include <vector>

namespace encased_column {

using FigureMaker = std::function<std::vector<Figure>(const std::vector<SetResult>&)>;

/// What `make` draws of the tests of each set of parameters alone, triaxial tests and columns
/// apart, panels of the same figure one below the other. The title of a panel names the set, unless
/// the runs do not, and columns where there are other tests.
std::vector<Figure> drawn_by_parameters(const std::vector<SetResult>& sets,
                                        const FigureMaker& make);

}  // namespace encased_column
