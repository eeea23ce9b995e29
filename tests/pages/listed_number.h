// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A number on a page and the place in a file it comes from: a row of
/// postprocess/results/numbers.csv.
struct ListedNumber {
  std::string page;     ///< from the top of the source tree
  std::string section;  ///< heading under which it stands
  std::string text;     ///< words around it: '@' is the number, '#' any other number
  std::string number;   ///< as the page prints it
  std::string file;     ///< from the top of the source tree
  std::string row;      ///< "a; b": a row with a cell that is a and one that is b; '*' is any text
  std::string column;   ///< heading, or a sum "0.5 * a + 0.5 * b - c" of columns of a history
  std::string pick;     ///< first, last, max, min, last over max, at COLUMN VALUE; empty: one row
  double scale = 1;     ///< page's unit over the file's
};

/// Throws std::runtime_error when the list cannot be read.
std::vector<ListedNumber> read_listed_numbers(const std::filesystem::path& list);

/// What the file says, in the page's unit. Throws std::runtime_error when file, column or row is
/// not there.
double value_in_file(const ListedNumber& listed, const std::filesystem::path& source);

/// Whether `number`, as printed, is `value` to within half of its last digit.
bool prints(const std::string& number, double value);

/// Where the numbers begin in `page`, the whole text of it: one place for each time that the text
/// stands in the section.
std::vector<std::size_t> places_on(const std::string& page, const ListedNumber& listed);

/// Where the numbers begin in the tables of `page` that follow a line `mark`, without their
/// headings and first columns.
std::vector<std::size_t> places_in_tables(const std::string& page, const std::string& mark);

}  // namespace encased_column::testing
