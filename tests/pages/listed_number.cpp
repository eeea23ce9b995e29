// SPDX-License-Identifier: GPL-2.0-only
#include "pages/listed_number.h"

#include "pages/word_table.h"
#include "support/csv_table.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace encased_column::testing {

namespace {

const std::string any_number = "[-+]?[0-9]+(?: [0-9]{3})*(?:\\.[0-9]+)?(?:e[-+]?[0-9]+)?";

std::vector<std::string> split(const std::string& text, const std::string& separator)
{
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(separator, from)) != std::string::npos;
       from = at + separator.size())
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

std::string escaped(const std::string& text)
{
  static const std::regex special(R"([-\[\]{}()*+?.,\\^$|])");
  return std::regex_replace(text, special, R"(\$&)");
}

double to_number(const std::string& text)
{
  std::string digits = text;
  digits.erase(std::remove(digits.begin(), digits.end(), ' '), digits.end());
  std::size_t read = 0;
  const double value = std::stod(digits, &read);
  if (read != digits.size()) throw std::runtime_error("'" + text + "' is not a number");
  return value;
}

bool cell_is(const std::string& cell, const std::string& pattern)
{
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos) return cell == pattern;
  const std::string end = pattern.substr(star + 1);
  return cell.size() + 1 >= pattern.size() && cell.compare(0, star, pattern, 0, star) == 0 &&
         cell.compare(cell.size() - end.size(), end.size(), end) == 0;
}

bool row_is(const std::vector<std::string>& cells, const std::string& wanted)
{
  for (const std::string& pattern : split(wanted, "; "))
    if (std::none_of(cells.begin(), cells.end(),
                     [&](const std::string& cell) { return cell_is(cell, pattern); }))
      return false;
  return true;
}

/// The cells of the rows that are wanted; those without a value ("-") are left out.
std::vector<double> values_of_tables(const std::vector<WordTable>& tables,
                                     const ListedNumber& listed)
{
  std::vector<double> values;
  for (const WordTable& table : tables)
    for (const auto& cells : table.rows)
      if (row_is(cells, listed.row)) {
        const std::string& cell = cells[table.column(listed.column)];
        if (cell != "-" && !cell.empty()) values.push_back(to_number(cell));
      }
  return values;
}

/// A sum of columns, row by row.
std::vector<double> sum_of_columns(const CsvTable& history, const std::string& sum)
{
  std::vector<double> values(history.rows(), 0.0);
  const std::string plus = " + ", minus = " - ";
  std::string terms = sum;
  for (std::size_t at; (at = terms.find(minus)) != std::string::npos;)
    terms.replace(at, minus.size(), plus + "-1 * ");
  for (const std::string& term : split(terms, plus)) {
    const auto parts = split(term, " * ");
    const double factor = parts.size() > 1 ? to_number(parts[0]) : 1.0;
    const std::vector<double> column = history.column(parts.back());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += factor * column[i];
  }
  return values;
}

/// `values` where the rising `column` reaches `wanted`, straight between samples.
double value_at(const std::vector<double>& column, const std::vector<double>& values, double wanted)
{
  for (std::size_t i = 1; i < values.size(); ++i)
    if (column[i] >= wanted) {
      const double share = (wanted - column[i - 1]) / (column[i] - column[i - 1]);
      return values[i - 1] + share * (values[i] - values[i - 1]);
    }
  throw std::runtime_error("the column ends before " + std::to_string(wanted));
}

double picked(const std::vector<double>& values, const std::string& pick)
{
  if (values.empty()) throw std::runtime_error("no such row");
  if (pick == "first") return values.front();
  if (pick == "last") return values.back();
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (pick == "max") return *most;
  if (pick == "min") return *least;
  if (pick == "last over max") return values.back() / *most;
  if (!pick.empty()) throw std::runtime_error("unknown pick '" + pick + "'");
  if (values.size() > 1)
    throw std::runtime_error(std::to_string(values.size()) + " rows are of that name");
  return values.front();
}

double value_of_history(const CsvTable& history, const ListedNumber& listed)
{
  const std::vector<double> values = sum_of_columns(history, listed.column);
  if (listed.pick.rfind("at ", 0) != 0) return picked(values, listed.pick);
  const std::size_t blank = listed.pick.rfind(' ');
  return value_at(history.column(listed.pick.substr(3, blank - 3)), values,
                  to_number(listed.pick.substr(blank + 1)));
}

struct Line {
  std::size_t begin;
  std::string text;
};

std::vector<Line> lines_with_places(const std::string& page)
{
  std::vector<Line> lines;
  std::size_t begin = 0;
  for (const std::string& text : split(page, "\n")) {
    lines.push_back({begin, text});
    begin += text.size() + 1;
  }
  return lines;
}

/// Begin and end of what stands under `heading`, up to the next heading.
std::pair<std::size_t, std::size_t> section_of(const std::string& page, const std::string& heading)
{
  static const std::regex is_heading("#+ (.*)");
  std::size_t begin = std::string::npos;
  bool code = false;
  for (const Line& line : lines_with_places(page)) {
    std::smatch match;
    if (line.text.rfind("```", 0) == 0) code = !code;
    if (code || !std::regex_match(line.text, match, is_heading)) continue;
    if (begin != std::string::npos) return {begin, line.begin};
    if (match[1] == heading) begin = line.begin + line.text.size();
  }
  if (begin == std::string::npos) throw std::runtime_error("no section '" + heading + "'");
  return {begin, page.size()};
}

}  // namespace

std::vector<ListedNumber> read_listed_numbers(const std::filesystem::path& list)
{
  const WordTable table = read_csv(list);
  std::vector<ListedNumber> numbers;
  for (const auto& row : table.rows) {
    const auto cell = [&](const char* heading) { return row[table.column(heading)]; };
    numbers.push_back({cell("page"), cell("section"), cell("text"), cell("number"), cell("file"),
                       cell("row"), cell("column"), cell("pick"), to_number(cell("scale"))});
  }
  return numbers;
}

double value_in_file(const ListedNumber& listed, const std::filesystem::path& source)
{
  const std::filesystem::path file = source / listed.file;
  if (listed.row.empty()) return listed.scale * value_of_history(CsvTable(file), listed);
  const std::vector<WordTable> tables = file.extension() == ".txt"
                                            ? read_printed_tables(file)
                                            : std::vector<WordTable>{read_csv(file)};
  return listed.scale * picked(values_of_tables(tables, listed), listed.pick);
}

bool prints(const std::string& number, double value)
{
  const std::size_t exponent = number.find('e');
  const std::size_t point = number.find('.');
  const int power = exponent == std::string::npos ? 0 : std::stoi(number.substr(exponent + 1));
  const int decimals =
      point == std::string::npos ? 0 : int(std::min(exponent, number.size()) - point - 1);
  const double half_a_digit = 0.5 * std::pow(10.0, power - decimals);
  return std::abs(value - to_number(number)) <= half_a_digit * (1 + 1e-9);
}

std::vector<std::size_t> places_on(const std::string& page, const ListedNumber& listed)
{
  std::string pattern;
  for (const char c : listed.text)
    pattern += c == '@'   ? "(" + escaped(listed.number) + ")(?![0-9]|[.][0-9])"
               : c == '#' ? any_number
               : c == ' ' ? "\\s+"
                          : escaped({c});
  const auto [begin, end] = section_of(page, listed.section);
  const std::regex text(pattern);
  std::vector<std::size_t> places;
  for (std::sregex_iterator match(page.begin() + begin, page.begin() + end, text), none;
       match != none; ++match)
    places.push_back(begin + match->position(1));
  return places;
}

std::vector<std::size_t> places_in_tables(const std::string& page, const std::string& mark)
{
  std::vector<std::size_t> places;
  int row = -1;  // of a marked table: 0 the headings, 1 the line below
  for (const Line& line : lines_with_places(page)) {
    if (line.text == mark) {
      row = 0;
    } else if (row >= 0 && line.text.rfind("|", 0) != 0) {
      row = -1;
    } else if (row >= 0 && row++ >= 2) {
      const std::regex number(any_number);
      const std::size_t first_cell_ends = line.text.find('|', 1);
      for (std::sregex_iterator match(line.text.begin() + first_cell_ends, line.text.end(), number),
           none;
           match != none; ++match)
        places.push_back(line.begin + first_cell_ends + match->position());
    }
  }
  return places;
}

}  // namespace encased_column::testing
