// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace encased_column {

/// Ends the run with `reason` where one rank alone knows it. The host's own way for that aborts all
/// ranks before what was printed reaches a file or a pipe.
[[noreturn]] inline void stop_from_one_rank(LAMMPS_NS::LAMMPS* lmp, const std::string& reason)
{
  if (lmp->comm->nprocs > 1) {
    std::fprintf(stderr, "ERROR: %s\n", reason.c_str());
    if (lmp->logfile) std::fprintf(lmp->logfile, "ERROR: %s\n", reason.c_str());
    std::fflush(nullptr);
    lmp->error->one(FLERR, reason.c_str());
  }
  lmp->error->all(FLERR, reason.c_str());
  std::abort();  // not reached: the host's call ends the program
}

/// Says in the log what `fix` will use, defaults included: once all its keywords are read, on its
/// own line and on that of `fix_modify`. `style` is the deck's word for it where the fix has taken
/// another name.
inline void say_understood(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix& fix,
                           const Options& options, const char* command = "fix",
                           const char* style = nullptr)
{
  if (lmp->comm->me != 0 || !lmp->logfile) return;
  std::fprintf(lmp->logfile, "%s %s (%s) uses: %s\n", command, fix.id, style ? style : fix.style,
               options.understood().c_str());
}

/// Makes the screen and the log of `lmp` safe against an abrupt end: every line is written at once,
/// and every rank knows where the log is, so that an error which one rank alone finds reaches both.
/// All ranks call it, again whenever the deck may have changed its log.
void secure_output(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
