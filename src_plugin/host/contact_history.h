// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

namespace encased_column {

/// The host's `delete_atoms`, carried out by `host`. With `compress yes`, its default, it gives the
/// grains that stay new numbers and leaves the old ones in what contacts remember, so that springs
/// are lost or go to other grains: here the memory gets the new numbers too.
void delete_grains(void (*host)(LAMMPS_NS::LAMMPS*, int, char**), LAMMPS_NS::LAMMPS* lmp, int narg,
                   char** arg);

/// Ends the run where contacts may remember something that `replicate` would give to other grains.
void refuse_replicated_contacts(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
