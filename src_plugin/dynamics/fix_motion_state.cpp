// What `fix motion` keeps with each grain and with the run: moves, copies and restarts.
#include "dynamics/fix_motion.h"

#include "host/pair_history.h"
#include "host/rank_sums.h"

#include <cstring>
#include <type_traits>

namespace encased_column {

void FixMotion::grow_arrays(int n)
{
  mass_scaling.resize(n);
}

void FixMotion::copy_arrays(int from, int to, int)
{
  mass_scaling.set_inertial_mass(to, inertial_mass(from));
}

// The host calls with -1 on a rank that got none of the grains of `read_data`.
void FixMotion::set_arrays(int i)
{
  if (i >= 0) mass_scaling.set_new(i);
  made_grains_ = true;
}

int FixMotion::pack_exchange(int i, double* buffer)
{
  buffer[0] = inertial_mass(i);
  return 1;
}

int FixMotion::unpack_exchange(int i, double* buffer)
{
  mass_scaling.set_inertial_mass(i, buffer[0]);
  return 1;
}

int FixMotion::pack_restart(int i, double* buffer)
{
  buffer[0] = size_restart(i);
  buffer[1] = inertial_mass(i);
  return size_restart(i);
}

// The host hands over each atom's record as a chain: the n-th block in it is ours.
void FixMotion::unpack_restart(int i, int nth)
{
  const double* block = atom->extra[i];
  for (int n = 0; n < nth; ++n) block += static_cast<int>(block[0]);
  mass_scaling.set_inertial_mass(i, block[1]);
}

// Called before the host packs the grains: what a signal asks for comes at any step.
void FixMotion::write_restart(FILE* file)
{
  static_assert(std::is_trivially_copyable_v<Saved>);
  finish_step();
  save_pair_history(lmp);
  const double loss = damping_loss();
  const bool anew = max_over_ranks(anew_ || made_grains_ ? 1.0 : 0.0, world) > 0.0;
  if (comm->me != 0) return;
  const Saved saved{
      update->get_cur_time(), loss, largest_factor_, stable_step_, equilibrium_, found_with_, anew};
  const int size = sizeof(Saved);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(&saved, sizeof(Saved), 1, file);
}

void FixMotion::restart(char* buffer)
{
  Saved saved;
  std::memcpy(&saved, buffer, sizeof(Saved));
  time_of_restart_ = saved.time;
  loss_ = comm->me == 0 ? saved.loss : 0.0;
  largest_factor_ = saved.largest_factor;
  stable_step_ = saved.stable_step;
  equilibrium_ = saved.equilibrium;
  found_with_ = saved.rule;
  anew_ = saved.anew;
  made_grains_ = false;  // none of those in the file is new
}

}  // namespace encased_column
