// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// What a browser says of pages.
struct BrowserVisit {
  nlohmann::json pages;              ///< by name, as browser_check.html tells it
  std::vector<std::string> console;  ///< what it wrote to its console
};

/// Opens the `pages` of `folder` (without network) in a headless browser, 390 px wide.
BrowserVisit visit(const std::filesystem::path& folder, const std::vector<std::string>& pages);

}  // namespace encased_column::testing
