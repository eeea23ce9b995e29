// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "dynamics/mass_scaling.h"
#include "host/host_types.h"

namespace encased_column {

/// Completes the rule for `step` and `safety` by what the deck's materials and contact law say, of
/// the atom types that grains may meet. Throws InputError, also for dashpots with density scaling.
void read_mass_rule(LAMMPS_NS::LAMMPS* lmp, MassScaling::Rule& rule);

}  // namespace encased_column
