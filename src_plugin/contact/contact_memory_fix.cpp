// SPDX-License-Identifier: GPL-2.0-only
#include "contact/contact_memory_fix.h"

#include "host/grains_and_box.h"

#include "memory.h"

#include <algorithm>
#include <utility>

namespace encased_column {

ContactMemoryFix::ContactMemoryFix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg)
{
  require_grains(lmp, *this);
  time_depend = 1;  // contacts remember step numbers
  restart_peratom = 1;
  create_attribute = 1;
  ContactMemoryFix::grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) ContactMemoryFix::set_arrays(i);
}

ContactMemoryFix::~ContactMemoryFix()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(place_);
}

void ContactMemoryFix::remember(const std::vector<int>& near)
{
  const std::vector<Memory> old = std::move(memories_);
  memories_ = std::vector<Memory>(near.size());
  for (std::size_t n = 0; n < near.size(); ++n)
    memories_[n] = place_[near[n]] == none ? nothing : old[place_[near[n]]];
  std::fill_n(place_, room_, none);
  for (std::size_t n = 0; n < near.size(); ++n) place_[near[n]] = static_cast<int>(n);
}

void ContactMemoryFix::bring(int i, const double* numbers)
{
  place_[i] = none;
  if (std::equal(numbers, numbers + memory_size_rolling, nothing.numbers)) return;
  place_[i] = static_cast<int>(memories_.size());
  std::copy_n(numbers, memory_size_rolling, memories_.emplace_back().numbers);
}

// `read_data add` names only the last of the grains it makes to set_arrays().
void ContactMemoryFix::grow_arrays(int n)
{
  memory->grow(place_, n, "wall:memory");
  if (n > room_) std::fill(place_ + room_, place_ + n, none);
  room_ = n;
}

void ContactMemoryFix::copy_arrays(int from, int to, int)
{
  place_[to] = place_[from];
}

// The host calls with -1 on a rank that got none of the grains of `read_data`.
void ContactMemoryFix::set_arrays(int i)
{
  if (i >= 0) place_[i] = none;
}

int ContactMemoryFix::pack_exchange(int i, double* buffer)
{
  std::copy_n(memory_of(i).numbers, memory_size_rolling, buffer);
  return memory_size_rolling;
}

int ContactMemoryFix::unpack_exchange(int i, double* buffer)
{
  bring(i, buffer);
  return memory_size_rolling;
}

int ContactMemoryFix::pack_restart(int i, double* buffer)
{
  buffer[0] = memory_size_rolling + 1;
  std::copy_n(memory_of(i).numbers, memory_size_rolling, buffer + 1);
  return memory_size_rolling + 1;
}

// The host hands over each atom's record as a chain: the n-th block in it is ours.
void ContactMemoryFix::unpack_restart(int nlocal, int nth)
{
  const double* block = atom->extra[nlocal];
  for (int n = 0; n < nth; ++n) block += static_cast<int>(block[0]);
  bring(nlocal, block + 1);
}

double ContactMemoryFix::memory_usage()
{
  return static_cast<double>(atom->nmax * sizeof(int) + memories_.capacity() * sizeof(Memory));
}

}  // namespace encased_column
