#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// The whole story of one test as one HTML page that needs no other file. Takes the 3-D pictures
/// from `pictures`. Needs a display.
std::string case_page(const TestResult& test, const Targets& targets,
                      const std::filesystem::path& pictures);

}  // namespace encased_column
