#pragma once

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

}  // namespace encased_column
