// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runs/run_program.h"

namespace encased_column {

/// The rows of the file of cases that `config` names, in its order. Throws InputError for one that
/// is not there.
std::vector<Case> rows_of_cases(const CalibrationConfig& config, const Places& places);

/// Lines that say what runs are of: parameters and ranges, cases, variables, program. Targets,
/// budget and search may change without making runs worthless, and do not stand there.
std::string identity_of(const CalibrationConfig& config, const std::vector<Case>& rows);

/// The points of the design and of Morris's ways.
std::vector<StoredPoint> first_points(const CalibrationConfig& config);

/// All runs of `points`, each case and packing, in order.
std::vector<PlannedRun> runs_of(const CalibrationConfig& config, const std::vector<Case>& rows,
                                const std::vector<StoredPoint>& points);

/// Seed of the packing of a run: another one for each point and repetition, so that a surrogate
/// smooths over packings and learns none.
int packing_seed(const CalibrationConfig& config, const RunKey& key);

}  // namespace encased_column
