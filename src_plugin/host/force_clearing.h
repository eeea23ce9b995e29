#pragma once

#include "host/host_types.h"

#include "integrate.h"

namespace encased_column {

/// Tells the host's integrator whether another clears the sums of forces: it is made for that, but
/// lets only its own kind say so.
struct ForceClearing : LAMMPS_NS::Integrate {
  static void leave_to_us(LAMMPS_NS::Integrate* integrator, bool left)
  {
    integrator->*(&ForceClearing::external_force_clear) = left;
  }
};

}  // namespace encased_column
