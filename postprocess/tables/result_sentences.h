// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/agreement.h"
#include "tables/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// What cohesion [Pa] may be off beside that: it stands where the line through the peaks meets no
/// stress, and moves by (1 - sin phi) / (2 cos phi) of what moves the smallest peak.
///
/// Source: Mohr-Coulomb at sigma3 = const, q = 2 c cos phi / (1 - sin phi) + ..., solved for c.
double cohesion_allowance(double smallest_peak, double friction_angle);

/// Three sentences, a line each: how much of what the laboratory measured `sets` have met within
/// near_laboratory, what they have not, and how their checks ended.
std::string result_sentences(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
