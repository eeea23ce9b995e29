// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "tables/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// What a reader of the rows of one test must know: a peak that is an average or at the end.
std::vector<std::string> test_notes(const TestResult& test);

/// The same for all tests of a set, whether there is no line, and in what the runs differ that it
/// goes through.
std::vector<std::string> result_notes(const SetResult& set);

/// The resolutions of the tests, for a heading; nothing if no deck has one.
std::string resolutions(const SetResult& set);

}  // namespace encased_column
