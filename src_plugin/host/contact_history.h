// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/find_fix.h"
#include "host/host_types.h"

#include "fix_contact_history.h"

#include <string>

namespace encased_column {

/// Brings the history of pair contacts up to date for a restart file that is being written.
///
/// The host keeps the history with its neighbour list and copies it to the grains when it builds
/// the list, before the forces of that step. A file written in the middle of a run, by `restart` or
/// after a signal, would hold the springs of one step earlier, which the contact law takes for a
/// contact that has parted. `write_restart` between runs makes the copy itself.
inline void save_pair_history(LAMMPS_NS::LAMMPS* lmp)
{
  const bool running = lmp->update->whichflag == 1;
  if (!running) return;
  for (auto* history : fixes_that_are<LAMMPS_NS::FixContactHistory>(lmp))
    if (std::string(history->style) == "contacthistory") history->pre_exchange();
}

/// The host's `delete_atoms`, carried out by `host`. With `compress yes`, its default, it gives the
/// grains that stay new numbers and leaves the old ones in what contacts remember, so that springs
/// are lost or go to other grains: here the memory gets the new numbers too.
void delete_grains(void (*host)(LAMMPS_NS::LAMMPS*, int, char**), LAMMPS_NS::LAMMPS* lmp, int narg,
                   char** arg);

/// Ends the run where contacts may remember something that `replicate` would give to other grains.
void refuse_replicated_contacts(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
