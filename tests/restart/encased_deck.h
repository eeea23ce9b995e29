// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "restart/specimen_deck.h"

#include <stdexcept>

namespace encased_column::testing {

// The specimen of specimen_deck.h in a sleeve in place of the cylinder, with room for a platen that
// the packing pushes out; grains roll against all walls.

inline std::string with_line(std::string deck, const std::string& begin, const std::string& line)
{
  const std::size_t from = deck.find(begin);
  if (from == std::string::npos) throw std::runtime_error("no line '" + begin + "' in the deck");
  return deck.replace(from, deck.find('\n', from) - from, line);
}

/// Materials and walls with a sleeve of which `more` says further words.
inline std::string materials_and_sleeve(const std::string& more)
{
  const std::string sleeve =
      "fix side all mesh/surface/shell cylinder 0.025 -0.005 0.055 edge 0.006 type 3 platens top "
      "bottom modulus 11.5e6 poisson 0.3 thickness 2e-3 density 30 " +
      more;
  return with_line(with_line(materials_and_walls, "fix            side", sleeve),
                   "fix            rolling",
                   "fix rolling all property/global coefficientRollingFriction peratomtypepair 3 "
                   "0.1 0.1 0.1 0.1 0 0 0.1 0 0");
}

/// Packing in the rigid sleeve, its release and the consolidation at 50 kPa.
inline const std::string encased_consolidation =
    "run 1000\nunfix grow\nrun 500\n"
    "fix_modify side rigid no pressure 50e3 ramp 1000\n"
    "fix_modify bottom servo 50e3 ramp 1000\n"
    "run 2000\n";

inline const std::string encased_shear =
    encased_consolidation + history + "fix_modify bottom velocity 1e-6\n";

/// The whole deck of a new encased specimen up to `commands`.
inline std::string new_encased_specimen(const std::string& commands, const std::string& more = "")
{
  return host + box + materials_and_sleeve("rigid yes " + more) + grains + motion + growth +
         commands;
}

/// A deck that reads the restart file `file` of one that was released and goes on with `commands`.
inline std::string encased_specimen_of(const std::string& file, const std::string& commands,
                                       const std::string& more = "")
{
  return host + "read_restart " + file + "\n" + materials_and_sleeve(more) + motion + commands;
}

/// Numbers of the sleeve with all their digits, added to `file`.
inline std::string sleeve_numbers(const std::string& file)
{
  std::string lines, names;
  for (int n = 1; n <= 18; ++n) {
    const std::string name = "sleeve" + std::to_string(n);
    lines += "variable " + name + " equal f_side[" + std::to_string(n) + "]\n";
    names += " ${" + name + "}";
  }
  return lines + "print \"" + names + "\" append " + file + "\n";
}

}  // namespace encased_column::testing
