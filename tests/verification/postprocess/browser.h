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

/// The window [px] of a browser.
struct WindowSize {
  int width, height;
};
constexpr WindowSize telephone{390, 844}, desk{1280, 800};

/// Opens the `pages` of `folder` (without network) in a headless browser, one after the other.
BrowserVisit visit(const std::filesystem::path& folder, const std::vector<std::string>& pages,
                   WindowSize window = telephone);

}  // namespace encased_column::testing
