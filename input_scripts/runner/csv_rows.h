#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// The rows of a CSV file (RFC 4180: cells in quotes may hold commas and doubled quotes), without
/// empty lines and lines that begin with '#'. A row is one line. Throws InputError with `name` and
/// the line's number for a quote that is not closed, text behind one, and a line of more than 10
/// 000 bytes.
std::vector<std::vector<std::string>> csv_rows(const std::string& text, const std::string& name);

/// `cell` as a CSV file holds it: in quotes where it needs them.
std::string csv_cell(const std::string& cell);

}  // namespace encased_column
