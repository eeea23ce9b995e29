#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

#include <cstdio>

namespace encased_column {

/// Says in the log what `fix` will use, defaults included: once all its keywords are read, on its
/// own line and on that of `fix_modify`.
inline void say_understood(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix& fix,
                           const Options& options, const char* command = "fix")
{
  if (lmp->comm->me != 0 || !lmp->logfile) return;
  std::fprintf(lmp->logfile, "%s %s (%s) uses: %s\n", command, fix.id, fix.style,
               options.understood().c_str());
}

}  // namespace encased_column
