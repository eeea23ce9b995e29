#pragma once

#include "reading/case_run.h"
#include "report/page_parts.h"

#include <filesystem>
#include <vector>

namespace encased_column {

/// The 3-D pictures of `run` that are in `folder`, made smaller to be `width` [px] wide at most.
std::vector<Picture> pictures_of(const CaseRun& run, const std::filesystem::path& folder,
                                 int width);

}  // namespace encased_column
