// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Becomes the program `encase-calibrate` beside this one, with `words` behind its name. Throws
/// InputError where it was not built.
[[noreturn]] void call_calibrate(const std::vector<std::string>& words);

}  // namespace encased_column
