// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// The text of a small file that a user writes or may have spoilt. Throws InputError, calling it
/// `what`, when it cannot be read, is larger than `most` bytes, or is not text in UTF-8.
std::string read_text_file(const std::filesystem::path& file, const std::string& what,
                           std::size_t most = 4'000'000);

/// Writes `text` so that a reader sees the old file or the new one; throws InputError when that is
/// impossible.
void write_text_file(const std::filesystem::path& file, const std::string& text);

/// Adds `text` at the end of a file, which is made if there is none.
void append_to_file(const std::filesystem::path& file, const std::string& text);

/// As a user types it: relative in the current folder, else whole.
std::string shown(const std::filesystem::path& path);

/// The rows of a CSV file (RFC 4180: cells in quotes may hold commas and doubled quotes), without
/// empty lines and lines that begin with '#'. A row is one line. Throws InputError with `name` and
/// the line's number for a quote that is not closed, text behind one, and a line of more than 10
/// 000 bytes.
std::vector<std::vector<std::string>> csv_rows(const std::string& text, const std::string& name);

/// `cell` as a CSV file holds it: in quotes where it needs them.
std::string csv_cell(const std::string& cell);

}  // namespace encased_column
