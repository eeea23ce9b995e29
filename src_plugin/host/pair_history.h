#pragma once

#include "host/contact_observer.h"

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

}  // namespace encased_column
