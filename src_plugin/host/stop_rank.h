#pragma once

#include "host/host_types.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace encased_column {

/// Ends the run from one rank, for a fault the others do not know of. The host shows such a message
/// on the screen only, which runs in the background do without: the log and the error stream get it
/// too.
[[noreturn]] inline void stop_from_rank(LAMMPS_NS::LAMMPS* lmp, const std::string& message)
{
  std::fprintf(stderr, "ERROR: %s\n", message.c_str());
  if (lmp->logfile) {
    std::fprintf(lmp->logfile, "ERROR: %s\n", message.c_str());
    std::fflush(lmp->logfile);
  }
  lmp->error->one(FLERR, message.c_str());
  std::abort();
}

}  // namespace encased_column
