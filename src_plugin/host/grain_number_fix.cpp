// SPDX-License-Identifier: GPL-2.0-only
#include "host/grain_number_fix.h"

#include "host/grains_and_box.h"

namespace encased_column {

GrainNumberFix::GrainNumberFix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg,
                               std::vector<double>& numbers)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      numbers_(numbers)
{
  require_grains(lmp, *this);
  restart_peratom = 1;
  create_attribute = 1;
  GrainNumberFix::grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) GrainNumberFix::set_arrays(i);
}

GrainNumberFix::~GrainNumberFix()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void GrainNumberFix::grow_arrays(int n)
{
  numbers_.resize(n);
}

void GrainNumberFix::copy_arrays(int from, int to, int)
{
  numbers_[to] = numbers_[from];
}

// The host calls with -1 on a rank that got none of the grains of `read_data`, and for all grains
// in the first set-up.
void GrainNumberFix::set_arrays(int i)
{
  if (i >= 0) numbers_[i] = 0.0;
  made_grains_ = true;
}

int GrainNumberFix::pack_exchange(int i, double* buffer)
{
  buffer[0] = numbers_[i];
  return 1;
}

int GrainNumberFix::unpack_exchange(int i, double* buffer)
{
  numbers_[i] = buffer[0];
  return 1;
}

int GrainNumberFix::pack_restart(int i, double* buffer)
{
  buffer[0] = size_restart(i);
  buffer[1] = numbers_[i];
  return size_restart(i);
}

// The host hands over each atom's record as a chain: the n-th block in it is ours.
void GrainNumberFix::unpack_restart(int i, int nth)
{
  const double* block = atom->extra[i];
  for (int n = 0; n < nth; ++n) block += static_cast<int>(block[0]);
  numbers_[i] = block[1];
}

}  // namespace encased_column
