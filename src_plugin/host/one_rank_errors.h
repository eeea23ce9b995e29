#pragma once

#include "host/host_types.h"

namespace encased_column {

/// Makes the screen and the log of `lmp` safe against an end without warning: every line is written
/// at once, and every rank knows where the log is, so that an error which one rank alone finds
/// reaches both. All ranks call it, again whenever the deck may have changed its log.
void secure_output(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
