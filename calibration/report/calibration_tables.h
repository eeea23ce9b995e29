// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "stages/calibration.h"
#include "tables/text_layout.h"

namespace encased_column {

// The tables of a calibration's report; the first row of each holds its headings.

/// Best value, median, interval, what of the spread is left, strongest correlation.
Rows parameter_rows(const CalibrationConfig& config, const Findings& found);
/// Laboratory's and found values beside the scatter of packings and the error of the surrogate.
Rows target_rows(const Findings& found);
/// R2 of each surrogate side by side, and which one is used.
Rows validation_rows(const CalibrationConfig& config, const Findings& found);
/// No rows without Morris's ways.
Rows morris_rows(const CalibrationConfig& config, const Findings& found);
Rows round_rows(const Findings& found);
Rows failed_rows(const Findings& found);
/// Some ten points of the front of mismatch and time.
Rows front_rows(const CalibrationConfig& config, const Findings& found);
/// How many runs it took, how long, and how many failed.
std::string cost_sentence(const Findings& found);

}  // namespace encased_column
