// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/style_catalogue.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace encased_column {

/// The page of `man` for `command`, which is called `name` ("encase run"), from the options that it
/// reads; that of the program itself names its commands. `version` stands at its foot.
std::string manual_page(const CLI::App& command, const std::string& name,
                        const std::string& version);

/// The page for `liggghts-encase`: its own options and the styles of the plugin.
std::string manual_page_of_host(const std::vector<PageStart>& styles, const std::string& version);

}  // namespace encased_column
