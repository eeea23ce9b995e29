#pragma once

#include "host/host_types.h"
#include "host/ignores_velocity.h"

namespace encased_column {

/// Stands first in every run, unseen by the deck: gives the host a request of signals
/// (stop_request.h) at a step on which all ranks agree.
class FixStopRequest : public LAMMPS_NS::Fix, public IgnoresVelocity {
 public:
  using Fix::Fix;

  /// Puts one into the run of `lmp` unless it has one; takes a box.
  static void add_to(LAMMPS_NS::LAMMPS* lmp);

  int setmask() override;
  void initial_integrate(int) override;
};

}  // namespace encased_column
