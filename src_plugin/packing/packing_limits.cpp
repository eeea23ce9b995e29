// SPDX-License-Identifier: GPL-2.0-only
#include "packing/packing_limits.h"

#include "core/input_error.h"

#include <cmath>
#include <istream>
#include <sstream>

namespace encased_column {

namespace {

const char limits_header[] =
    "gradation [-],distribution [-],finest [m],radius [m],height [m],friction [-],"
    "rolling_friction [-],modulus [Pa],stress [Pa],seed [-],loosest_porosity [-],"
    "densest_porosity [-]";
constexpr std::size_t columns = 12;

double void_ratio(double porosity)
{
  return porosity / (1.0 - porosity);
}

std::vector<std::string> values_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

bool same(double a, double b)
{
  return std::abs(a - b) <= 1e-6 * std::abs(b);
}

bool is_of(const PackingCase& a, const PackingCase& b)
{
  return a.gradation == b.gradation && a.distribution == b.distribution &&
         same(a.finest, b.finest) && same(a.radius, b.radius) && same(a.height, b.height) &&
         same(a.friction, b.friction) && same(a.rolling_friction, b.rolling_friction);
}

std::string in_words(const PackingCase& c)
{
  using encased_column::in_words;
  return c.gradation + " " + c.distribution + ", finest " + in_words(c.finest) + " m, radius " +
         in_words(c.radius) + " m, height " + in_words(c.height) + " m, friction " +
         in_words(c.friction) + ", rolling friction " + in_words(c.rolling_friction);
}

}  // namespace

double PackingLimits::porosity_at(double d) const
{
  const double e = void_ratio(loosest) - d * (void_ratio(loosest) - void_ratio(densest));
  return e / (1.0 + e);
}

PackingLimits read_packing_limits(std::istream& in, const std::string& file,
                                  const PackingCase& wanted)
{
  PackingLimits sum{0.0, 0.0};
  int rows = 0, number = 0;
  bool has_header = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::string place = file + ":" + std::to_string(number);
    if (!has_header) {
      if (line != limits_header)
        throw InputError("'limits' " + place + " must start with the line '" + limits_header +
                         "', found '" + line + "', write it above the rows");
      has_header = true;
      continue;
    }
    const std::vector<std::string> cells = values_of(line);
    if (cells.size() != columns)
      throw InputError("'limits' " + place + " must have " + std::to_string(columns) +
                       " values, found " + std::to_string(cells.size()) + ", write '" +
                       limits_header + "'");
    const auto value = [&](std::size_t n) { return read_number("limits " + place, cells[n]); };
    const std::string gradation = cells[0].substr(cells[0].rfind('/') + 1);
    const PackingCase row{gradation, cells[1], value(2), value(3), value(4), value(5), value(6)};
    const PackingLimits found{value(10), value(11)};
    if (!(0.0 < found.densest && found.densest < found.loosest && found.loosest < 1.0))
      throw InputError("'limits' " + place +
                       " must have a loosest porosity above the densest, both between 0 and 1, "
                       "found " +
                       in_words(found.loosest) + " and " + in_words(found.densest) +
                       ", correct the row");
    if (!is_of(row, wanted)) continue;
    sum.loosest += found.loosest;
    sum.densest += found.densest;
    ++rows;
  }
  if (rows == 0)
    throw InputError("'limits' must have a row for this packing, found none in " + file + " for " +
                     in_words(wanted) +
                     ", make one with the deck packing_limits/limits.lmp and add it to the table");
  return {sum.loosest / rows, sum.densest / rows};
}

}  // namespace encased_column
