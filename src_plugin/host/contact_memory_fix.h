#pragma once

#include "contact/resolve_contact.h"
#include "host/blind_to_velocity.h"
#include "host/host_types.h"

namespace encased_column {

/// A fix that is a wall: each grain remembers one contact with it, and the memory goes along when
/// grains change places or ranks and into restart files.
class ContactMemoryFix : public LAMMPS_NS::Fix, public BlindToVelocity {
 public:
  ContactMemoryFix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~ContactMemoryFix() override;

  void grow_arrays(int n) override;
  void copy_arrays(int from, int to, int delete_flag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int) override { return memory_size_rolling + 1; }
  int maxsize_restart() override { return memory_size_rolling + 1; }

 protected:
  /// What the contact of grain i with this wall remembers.
  double* contact_memory(int i) const { return memory_[i]; }

 private:
  double** memory_ = nullptr;
};

}  // namespace encased_column
