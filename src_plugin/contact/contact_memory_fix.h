// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/resolve_contact.h"
#include "host/host_types.h"
#include "host/velocity_watchers.h"

#include <vector>

namespace encased_column {

/// A fix that is a wall: the grains near it remember one contact each, and the memory goes along
/// when grains change places or ranks and into restart files. The memories lie side by side in the
/// order of the wall's list: rows as far apart as their grains in the host's arrays took two fifths
/// of the time to find the contacts.
class ContactMemoryFix : public LAMMPS_NS::Fix, public IgnoresVelocity {
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
  double memory_usage() override;

 protected:
  /// Takes over a new list of the grains near the wall; those it leaves out do not touch.
  void remember(const std::vector<int>& near);
  /// What the contact of grain `near[n]` with this wall remembers.
  double* contact_memory(int n) { return memories_[n].numbers; }

 private:
  struct Memory {
    double numbers[memory_size_rolling];
  };
  /// Of a grain that never touched: step 0 counts as a first contact too.
  static constexpr Memory nothing{{0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0}};
  static constexpr int none = -1;

  const Memory& memory_of(int i) const
  {
    return place_[i] == none ? nothing : memories_[place_[i]];
  }
  void bring(int i, const double* numbers);

  int* place_ = nullptr;  ///< of each grain's memory, or none
  int room_ = 0;          ///< for so many
  std::vector<Memory> memories_;
};

}  // namespace encased_column
