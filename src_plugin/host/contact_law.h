// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// A number for every pair of atom types, as `fix ... property/global NAME peratomtypepair`
/// gives it; types count from 1.
class PairProperty {
 public:
  PairProperty(int types, double value) : types_(types), values_(types * types, value) {}
  double& at(int i, int j) { return values_[(i - 1) * types_ + (j - 1)]; }
  double at(int i, int j) const { return values_[(i - 1) * types_ + (j - 1)]; }

 private:
  int types_;
  std::vector<double> values_;
};

/// Reads the property NAME; throws InputError when it is missing and there is no `otherwise`, when
/// it is not symmetric, and when a value is below `low` (or equal to it with `above`).
PairProperty read_pair_property(LAMMPS_NS::LAMMPS* lmp, const std::string& name, double low,
                                bool above, std::optional<double> otherwise = {});

/// Throws InputError where contacts would not follow the linear law: `needs_it` in the deck, such
/// as "fix move of style motion", reads its stiffness and its springs, which another law keeps
/// otherwise or not at all. Walls of the host are checked too.
void require_linear_law(LAMMPS_NS::LAMMPS* lmp, const std::string& needs_it);

}  // namespace encased_column
