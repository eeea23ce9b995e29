// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/target_values.h"
#include "tables/evaluation.h"

namespace encased_column {

/// What the published values are read from, of `test`, which belongs to `set`. Throws InputError if
/// the strip table that the run names cannot be read.
TargetRecord target_record(const SetResult& set, const TestResult& test);

/// Its shape alone.
SpecimenShape specimen_shape(const TestResult& test);

/// What a row of targets.csv asks a test for.
TestCondition test_condition(const TestResult& test);

}  // namespace encased_column
