// What `fix output/grains` keeps with each grain and with the run: moves, copies and restarts.
#include "output/fix_output_grains.h"

#include "host/restart_block.h"
#include "memory.h"

#include <algorithm>

namespace encased_column {

void FixOutputGrains::grow_arrays(int capacity)
{
  memory->grow(start_, capacity, 3, "output/grains:start");
  memory->grow(rotation_, capacity, 3, "output/grains:rotation");
}

void FixOutputGrains::copy_arrays(int from, int to, int)
{
  std::copy_n(start_[from], 3, start_[to]);
  std::copy_n(rotation_[from], 3, rotation_[to]);
}

/// A new grain, and every grain on `reset`, starts where it is.
void FixOutputGrains::set_arrays(int i)
{
  domain->unmap(atom->x[i], atom->image[i], start_[i]);
  std::fill_n(rotation_[i], 3, 0.0);
}

int FixOutputGrains::pack_exchange(int i, double* buffer)
{
  std::copy_n(rotation_[i], 3, std::copy_n(start_[i], 3, buffer));
  return values_per_grain;
}

int FixOutputGrains::unpack_exchange(int i, double* buffer)
{
  std::copy_n(buffer, 3, start_[i]);
  std::copy_n(buffer + 3, 3, rotation_[i]);
  return values_per_grain;
}

int FixOutputGrains::pack_restart(int i, double* buffer)
{
  buffer[0] = values_per_grain + 1;
  return 1 + pack_exchange(i, buffer + 1);
}

/// The data of all fixes lie one behind the other, each led by its length.
void FixOutputGrains::unpack_restart(int i, int nth)
{
  double* values = atom->extra[i];
  for (int fix = 0; fix < nth; ++fix) values += static_cast<int>(values[0]);
  unpack_exchange(i, values + 1);
}

/// The time, then the series.
void FixOutputGrains::write_restart(FILE* file)
{
  if (comm->me == 0) write_block(file, {clock_.now()}, series_->saved());
}

void FixOutputGrains::restart(char* buffer)
{
  RestartBlock block(buffer);
  clock_.restart(block.take());
  written_ = *block.text() != '\0';
  if (comm->me == 0 && !series_->restore(block.text()))
    files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
}

double FixOutputGrains::memory_usage()
{
  return static_cast<double>(atom->nmax) * values_per_grain * sizeof(double);
}

}  // namespace encased_column
