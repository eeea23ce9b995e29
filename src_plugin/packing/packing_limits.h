// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace encased_column {

/// What a packing's loosest and densest state depend on.
struct PackingCase {
  std::string gradation;     ///< name of its file, without folders
  std::string distribution;  ///< inside a class
  double finest;             ///< diameter below which grains are left out [m]
  double radius, height;     ///< of the specimen, since grains pack looser at walls [m]
  double friction;           ///< with which the loosest packing was made [-]
  double rolling_friction;   ///< likewise [-]
};

/// Porosities [-] between which grains pack.
struct PackingLimits {
  double loosest;  ///< with all friction
  double densest;  ///< without

  /// Porosity at the relative density `d` [-]: void ratios e = n / (1 - n) lie d (e_max - e_min)
  /// below e_max. Source: ISO 14688-2, density index I_D = (e_max - e) / (e_max - e_min).
  double porosity_at(double d) const;
};

/// Reads a table of packing limits and returns the mean of the rows of `wanted`, which may be of
/// several seeds; a gradation is known by the name of its file, without folders. `file` is the
/// table's name, for sentences. Throws InputError where a line is malformed
/// and where no row is of that case.
PackingLimits read_packing_limits(std::istream& in, const std::string& file,
                                  const PackingCase& wanted);

}  // namespace encased_column
