// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// The last `most` bytes of `file`, empty if there is none.
std::string end_of(const std::filesystem::path& file, std::streamoff most);

/// Why a run ended: the errors at the end of its log, else those of its screen, else the last lines
/// of its screen; at most six lines, each with its line end.
std::string last_words_of(const std::filesystem::path& log, const std::filesystem::path& screen);

}  // namespace encased_column
