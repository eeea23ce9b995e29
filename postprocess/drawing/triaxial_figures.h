#pragma once

#include "drawing/figure.h"
#include "reading/targets.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

/// deviatoric_stress and volumetric_strain over axial strain, one curve for each test, and p_q, the
/// peaks with the fitted and the published failure lines of each set. Where a folder holds plain
/// and encased tests, the plain ones are dashed.
std::vector<Figure> triaxial_figures(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
