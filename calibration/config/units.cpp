// SPDX-License-Identifier: GPL-2.0-only
#include "config/units.h"

#include "core/constants.h"
#include "core/input_error.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace encased_column {

namespace {

struct Unit {
  const char* name;
  const char* si;
  double size;
};

const std::vector<Unit>& units()
{
  static const std::vector<Unit> all{
      {"Pa", "Pa", 1.0},         {"kPa", "Pa", 1e3}, {"MPa", "Pa", 1e6},  {"GPa", "Pa", 1e9},
      {"-", "-", 1.0},           {"%", "-", 0.01},   {"rad", "rad", 1.0}, {"deg", "rad", pi / 180},
      {"m", "m", 1.0},           {"mm", "m", 1e-3},  {"N/m", "N/m", 1.0}, {"kN/m", "N/m", 1e3},
      {"kg/m^3", "kg/m^3", 1.0}, {"N", "N", 1.0},    {"s", "s", 1.0},
  };
  return all;
}

std::string names_for(const std::string& si)
{
  std::string names;
  for (const Unit& one : units())
    if (si == one.si) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names.empty() ? si : names;
}

}  // namespace

double read_in_unit(const std::string& keyword, const std::string& word, const std::string& unit)
{
  const std::size_t blank = word.find_last_of(' ');
  std::string number = word.substr(0, blank), name = unit == "rad" ? "" : unit;
  if (blank != std::string::npos)
    name = word.substr(blank + 1);
  else if (!word.empty() && word.back() == '%') {
    number.pop_back();
    name = "%";
  }
  for (const Unit& one : units())
    if (name == one.name && unit == one.si) return one.size * read_number(keyword, number);
  if (name == unit) return read_number(keyword, number);
  throw InputError(keyword + " takes a number in one of the units " + names_for(unit) +
                   ", found '" + word + "', write for example '" +
                   (unit == "rad" ? "36.4 deg" : "1 " + unit) + "'");
}

UsualUnit usual_unit(double size, const std::string& unit)
{
  if (unit == "Pa" && std::abs(size) >= 2e6) return {"MPa", 1e6};
  if (unit == "Pa" && std::abs(size) >= 100.0) return {"kPa", 1e3};
  if (unit == "rad") return {"deg", pi / 180.0};
  if (unit == "N/m" && std::abs(size) >= 2e3) return {"kN/m", 1e3};
  if (unit == "m" && std::abs(size) < 0.1 && size != 0.0) return {"mm", 1e-3};
  return {unit, 1.0};
}

std::string in_usual_unit(double value, const std::string& unit, int digits)
{
  return in_unit_like(value, value, unit, digits);
}

std::string in_unit_like(double value, double like, const std::string& unit, int digits)
{
  const UsualUnit usual = usual_unit(like, unit);
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value / usual.size);
  return usual.name == "-" ? text : std::string(text) + " " + usual.name;
}

}  // namespace encased_column
