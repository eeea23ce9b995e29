// What `fix output/grains` keeps with each grain and with the run: moves, copies and restarts.
#include "output/fix_output_grains.h"

#include "host/stop_run.h"
#include "output/whole_file.h"

#include "memory.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace encased_column {

void FixOutputGrains::grow_arrays(int capacity)
{
  memory->grow(motion_, capacity, values_per_grain, "output/grains:motion");
}

void FixOutputGrains::copy_arrays(int from, int to, int)
{
  std::copy_n(motion_[from], values_per_grain, motion_[to]);
}

/// A new grain, and every grain on `reset`, starts where it is.
void FixOutputGrains::set_arrays(int i)
{
  std::fill_n(motion_[i], values_per_grain, 0.0);
  domain->unmap(atom->x[i], atom->image[i], motion_[i]);
}

int FixOutputGrains::pack_exchange(int i, double* buffer)
{
  std::copy_n(motion_[i], values_per_grain, buffer);
  return values_per_grain;
}

int FixOutputGrains::unpack_exchange(int i, double* buffer)
{
  std::copy_n(buffer, values_per_grain, motion_[i]);
  return values_per_grain;
}

int FixOutputGrains::pack_restart(int i, double* buffer)
{
  buffer[0] = values_per_grain + 1;
  std::copy_n(motion_[i], values_per_grain, buffer + 1);
  return values_per_grain + 1;
}

/// The data of all fixes lie one behind the other, each led by its length.
void FixOutputGrains::unpack_restart(int i, int nth)
{
  const double* values = atom->extra[i];
  for (int fix = 0; fix < nth; ++fix) values += static_cast<int>(values[0]);
  std::copy_n(values + 1, values_per_grain, motion_[i]);
}

/// The time now, then the series as lines "time file", ended by a zero byte.
void FixOutputGrains::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::ostringstream lines;
  lines.precision(17);
  lines << time_now() << '\n';
  for (const PvdEntry& entry : collection_.entries())
    lines << entry.time << ' ' << entry.file << '\n';
  const std::string text = lines.str();
  const int bytes = static_cast<int>(text.size() + 1);
  std::fwrite(&bytes, sizeof bytes, 1, file);
  std::fwrite(text.c_str(), 1, text.size() + 1, file);
}

/// Goes on with the series, as far as its files are still in the folder, and with its time; files
/// that the run wrote after its restart file are listed no more, they come again.
void FixOutputGrains::restart(char* buffer)
{
  std::istringstream lines(buffer);
  double time = 0.0;
  lines >> time;
  time_of_restart_ = time;
  std::string file;
  while (lines >> time && std::getline(lines >> std::ws, file))
    if (std::filesystem::exists(folder_ + "/" + file)) collection_.add(time, file);
  written_ = std::strchr(buffer, ' ') != nullptr;
  if (comm->me == 0 && !write_whole_file(folder_ + "/" + name_ + ".pvd", collection_.text()))
    stop_from_one_rank(lmp, ("cannot write into '" + folder_ + "', free some space"));
}

double FixOutputGrains::memory_usage()
{
  return static_cast<double>(atom->nmax) * values_per_grain * sizeof(double);
}

}  // namespace encased_column
