// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace encased_column {

/// Name of `path` while it is being written.
std::string unfinished(const std::string& path);

/// Gives a finished file its name, so that a reader sees the old file or the new one and never a
/// part; false when that is impossible.
bool finish_file(const std::string& path);

/// Writes `text` into `path` by way of its unfinished name; false when that is impossible.
bool write_whole_file(const std::string& path, const std::string& text);

}  // namespace encased_column
