// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "drawing/figure.h"
#include "reading/targets.h"
#include "tables/evaluation.h"

#include <vector>

namespace encased_column {

// Tests made with several sets of parameters are drawn apart: each figure over axial strain, p or
// displacement has its panels once for each set, whose name their titles end with.

/// What the first screen of a page shows: agreement, q of both platens over axial strain, a panel
/// for each kind of triaxial tests, with the laboratory's peaks and its E50. Of columns alone the
/// first of column_series_figures(). One figure, or none.
std::vector<Figure> agreement_figures(const std::vector<SetResult>& sets, const Targets& targets);

/// What only encased tests have, a panel for each test: radial_strain (at three heights, with the
/// study's end values), platens (q of both, with the closed form), radial_profile (along the
/// height) and hoop_tension (mean and largest, with the limit of the strip test); and
/// radial_expansion, along the height of all tests at the study's 12 and 24 mm of displacement.
/// Leaves out what the runs did not write; nothing without encased tests.
std::vector<Figure> sleeve_figures(const std::vector<SetResult>& sets, const Targets& targets);

/// deviatoric_stress and volumetric_strain over axial strain, one curve for each test, and p_q, the
/// peaks with the fitted and the published failure lines of each set. Where a folder holds plain
/// and encased tests, the plain ones are dashed.
std::vector<Figure> triaxial_figures(const std::vector<SetResult>& sets, const Targets& targets);

/// How the load went in, one curve for each test: pressure_displacement, the pressure on each
/// platen over the displacement, and stress_path, q over p at the boundary and of the grains in the
/// middle third, with the published failure lines.
std::vector<Figure> load_figures(const std::vector<SetResult>& sets, const Targets& targets);

/// Columns beside one another: column_pressure_density and column_pressure_gradation, the pressure
/// on each platen over the displacement, with the numbers that the study tells; column_expansion_*,
/// along the height at its 12 and 24 mm; and column_profile, each column at several displacements.
/// Only those of gradations if there are others than the study's S1; nothing without columns.
std::vector<Figure> column_series_figures(const std::vector<SetResult>& sets,
                                          const Targets& targets);

/// Inside the specimen, from its measuring spheres, for each test that has them: column_stress_<id>
/// along the height, column_porosity_<id> and column_coordination_<id> over displacement and along
/// the height, and contact_force_<id> over axial strain, with those of the whole specimen if the
/// run wrote them. The study's numbers of its column stand in those of the same column.
std::vector<Figure> column_figures(const std::vector<SetResult>& sets, const Targets& targets);

/// How well the runs went: unbalanced ratio, inertial number, platen difference of plain tests,
/// over axial strain.
Figure check_figure(const std::vector<SetResult>& sets);

/// energy_<id>: where the work of each test went.
std::vector<Figure> energy_figures(const std::vector<SetResult>& sets);

}  // namespace encased_column
