// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace encased_column {

/// What bash and zsh read to complete the words of `app`: its commands, their options, and the
/// values of those whose values are known. Cases, series, variables and styles are asked from the
/// program itself at that moment.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace encased_column
