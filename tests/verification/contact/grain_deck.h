// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"
#include "support/csv_table.h"

#include <cmath>
#include <sstream>
#include <string>

namespace encased_column::testing {

// The grain of the opening decks.
constexpr double radius = 0.01;     // m
constexpr double density = 2500.0;  // kg/m^3
const double pi = std::acos(-1.0);
const double mass = density * 4.0 / 3.0 * pi * radius * radius * radius;

/// `x` with all its digits.
inline std::string digits(double x)
{
  std::ostringstream text;
  text.precision(17);
  text << x;
  return text.str();
}

/// A box without grains, with all pairs of the two types of one material; further lines follow.
inline std::string material(double modulus, double friction, double beta_n = 0.0,
                            double beta_s = 0.0)
{
  const auto all_pairs = [](const std::string& name, double value) {
    std::string line = "fix " + name + " all property/global " + name + " peratomtypepair 2";
    for (int n = 0; n < 4; ++n) line += " " + digits(value);
    return line + "\n";
  };
  return opening_deck("empty_cylinder") + "unfix modulus\nunfix friction\n" +
         all_pairs("contactModulus", modulus) + all_pairs("coefficientFriction", friction) +
         all_pairs("dampingRatioNormal", beta_n) + all_pairs("dampingRatioShear", beta_s);
}

/// A grain of type 1 at a point.
inline std::string grain(double x, double y, double z)
{
  return "create_atoms 1 single " + digits(x) + " " + digits(y) + " " + digits(z) + " units box\n";
}

inline const std::string grain_size = "set group all diameter 0.02 density 2500\n";

/// A platen at a height, of which only the contact counts.
inline std::string platen(const std::string& position, double z)
{
  return "fix " + position + " all servo/platen position " + position + " z " + digits(z) +
         " area 1 type 2\n";
}

/// Motion without damping at the step given.
inline std::string plain_motion(double step)
{
  return "fix move all nve/sphere\ntimestep " + digits(step) + "\n";
}

/// Lines that set velocity or spin of all grains.
inline std::string velocity(double x, double y, double z)
{
  return "velocity all set " + digits(x) + " " + digits(y) + " " + digits(z) + " units box\n";
}

/// Prints numbers the deck knows as "name value"; `what` is a list like "z[1] vz[1]".
inline std::string print_numbers(const std::string& what)
{
  std::istringstream words(what);
  std::string lines;
  int n = 0;
  for (std::string word; words >> word; ++n) {
    const std::string name = "number" + std::to_string(n);
    lines += "variable " + name + " equal " + word + "\nprint \"" + word + " ${" + name + "}\"\n";
  }
  return lines;
}

/// Writes the same numbers into track.csv every so many steps, under their own names.
inline std::string track_numbers(const std::string& what, int every)
{
  std::istringstream words(what);
  std::string variables, names, values;
  int n = 0;
  for (std::string word; words >> word; ++n) {
    const std::string name = "tracked" + std::to_string(n);
    variables += "variable " + name + " equal " + word + "\n";
    names += (n ? "," : "") + word;
    values += (n ? ",${" : "${") + name + "}";
  }
  return variables + "fix track all print " + std::to_string(every) + " \"" + values +
         "\" file track.csv screen no title \"" + names + "\"\n";
}

/// Runs a deck that must end well.
inline Outcome run_well(const std::string& deck)
{
  const Outcome outcome = run_deck(deck);
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  return outcome;
}

/// Runs a deck with track_numbers() and reads what it left.
inline CsvTable track_of(const std::string& deck)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(deck, 1, folder.path());
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  return CsvTable(folder.path() / "track.csv");
}

}  // namespace encased_column::testing
