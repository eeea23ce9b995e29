// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

using Rows = std::vector<std::vector<std::string>>;

/// `rows`, of which the first holds the headings, in columns for reading: words flush left,
/// numbers (and what stands below a heading of `right` set) flush right, a rule below the headings.
std::string aligned(const Rows& rows, const std::vector<bool>& right);

/// `rows` as CSV, RFC 4180: words with a comma or a quotation mark are quoted.
std::string comma_separated(const Rows& rows);

/// `x` with `decimals` digits after the point.
std::string fixed(double x, int decimals);

/// Writes `text`; throws InputError if the file cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace encased_column
