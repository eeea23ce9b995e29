// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/command_line.h"

#include <filesystem>

namespace encased_column {

/// `encase texts FOLDER`, which the build calls: writes the pages of `man` and the completions of
/// the shells for `line` into `folder`. Throws InputError where that is impossible.
void write_shell_texts(const CommandLine& line, const std::filesystem::path& folder);

}  // namespace encased_column
