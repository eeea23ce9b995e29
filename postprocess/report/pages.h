// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// The tests of a series beside one another as one HTML page that needs no other file but links to
/// the reports of the tests. It will lie in `folder`, whose figures/ holds the 3-D pictures;
/// `left_out` says which cases are missing and why. Needs a display.
std::string series_page(const std::vector<SetResult>& sets, const Targets& targets,
                        const std::filesystem::path& folder,
                        const std::vector<std::string>& left_out);

/// The whole story of one test as one HTML page that needs no other file. Takes the 3-D pictures
/// from `pictures`. Needs a display.
std::string case_page(const TestResult& test, const Targets& targets,
                      const std::filesystem::path& pictures);

}  // namespace encased_column
