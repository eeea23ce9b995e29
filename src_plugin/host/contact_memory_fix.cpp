#include "host/contact_memory_fix.h"

#include "memory.h"

#include <algorithm>

namespace encased_column {

ContactMemoryFix::ContactMemoryFix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg)
{
  if (!atom->radius_flag || !atom->rmass_flag)
    error->fix_error(FLERR, this, "atoms have no radius and mass, use 'atom_style granular'");
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
  memory->destroy(memory_);
}

void ContactMemoryFix::grow_arrays(int n)
{
  memory->grow(memory_, n, memory_size_rolling, "wall:memory");
}

void ContactMemoryFix::copy_arrays(int from, int to, int)
{
  std::copy_n(memory_[from], memory_size_rolling, memory_[to]);
}

void ContactMemoryFix::set_arrays(int i)
{
  std::fill_n(memory_[i], memory_size_rolling, 0.0);
  memory_[i][3] = -1.0;  // never touched: step 0 counts as a first contact too
}

int ContactMemoryFix::pack_exchange(int i, double* buffer)
{
  std::copy_n(memory_[i], memory_size_rolling, buffer);
  return memory_size_rolling;
}

int ContactMemoryFix::unpack_exchange(int i, double* buffer)
{
  std::copy_n(buffer, memory_size_rolling, memory_[i]);
  return memory_size_rolling;
}

int ContactMemoryFix::pack_restart(int i, double* buffer)
{
  buffer[0] = memory_size_rolling + 1;
  std::copy_n(memory_[i], memory_size_rolling, buffer + 1);
  return memory_size_rolling + 1;
}

// The host hands over each atom's record as a chain: the n-th block in it is ours.
void ContactMemoryFix::unpack_restart(int nlocal, int nth)
{
  const double* block = atom->extra[nlocal];
  for (int n = 0; n < nth; ++n) block += static_cast<int>(block[0]);
  std::copy_n(block + 1, memory_size_rolling, memory_[nlocal]);
}

}  // namespace encased_column
