#pragma once

#include "drawing/figure.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

/// Inside the column, from its measuring spheres, for each test that has them: column_stress_<id>
/// along the height, column_porosity_<id> and column_coordination_<id> over displacement and along
/// the height, and contact_force_<id> over axial strain, with those of the whole specimen if the
/// run wrote them.
std::vector<Figure> column_figures(const std::vector<SetResult>& sets);

}  // namespace encased_column
