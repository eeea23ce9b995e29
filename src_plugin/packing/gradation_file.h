// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "packing/gradation.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace encased_column {

/// Reads and checks a gradation: a first line `diameter_low [m],diameter_high [m],mass_percent [%]`
/// and one class per line; empty lines and lines that start with # are skipped.
/// Throws InputError naming `file` and the line.
Gradation read_gradation(std::istream& in, const std::string& file);

/// What a packing's report says beside the table of its classes.
struct PackingSummary {
  std::size_t count;             ///< grains
  double porosity;               ///< at full size, overlaps counted twice [-]
  CharacteristicSizes by_sieve;  ///< read from the sieved masses, log-uniform between sieves
  CharacteristicSizes by_grain;  ///< of the grains one by one
};

/// Writes the classes with percents wanted and achieved, then the summary in lines of `#
/// name,value`.
void write_gradation(std::ostream& out, const Gradation& wanted,
                     const std::vector<ClassContent>& achieved, const PackingSummary& summary);

/// The gradation that sieving gave: the classes of `wanted` with the percents of `achieved`.
Gradation sieved_gradation(Gradation wanted, const std::vector<ClassContent>& achieved);

}  // namespace encased_column
