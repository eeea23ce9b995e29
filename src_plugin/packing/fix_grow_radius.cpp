#include "packing/fix_grow_radius.h"

#include "core/input_error.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"
#include "packing/growth_law.h"

namespace encased_column {

const KeywordTable FixGrowRadius::keywords{
    {"from", 1, "-",
     "radius over full radius at the start, 0.01 to 1 (`start_factor` of create_packing)"},
    {"stages", 1, "-", "number of stages in which the radii grow (default 100)"},
    {"relax", 1, "steps", "steps from one stage to the next (default 50)"},
};

FixGrowRadius::FixGrowRadius(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      begin_(update->ntimestep)
{
  try {
    const Options options = keywords.read(narg, arg);
    start_ = options.between("from", 0.01, 1.0);
    stages_ = options.integer("stages", 1, 100);
    steps_per_stage_ = options.integer("relax", 1, 50);
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  factor_ = start_;
  force_reneighbor = 1;
  next_reneighbor = begin_ + 1;
  rad_mass_vary_flag = 1;
  restart_global = 1;
  scalar_flag = 1;
  global_freq = 1;
}

int FixGrowRadius::setmask()
{
  return LAMMPS_NS::FixConst::INITIAL_INTEGRATE;
}

// Before the host decides on its lists, so that a stage and the list that knows it share a step.
void FixGrowRadius::initial_integrate(int)
{
  const LAMMPS_NS::bigint done = update->ntimestep - begin_ - 1;
  if (done % steps_per_stage_ != 0 || factor_ == 1.0) return;
  const double stage = static_cast<double>(done / steps_per_stage_ + 1);
  const double next = growth_factor(start_, stage / static_cast<double>(stages_));
  const double ratio = next / factor_;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    atom->radius[i] *= ratio;
    atom->rmass[i] *= ratio * ratio * ratio;
  }
  factor_ = next;
  next_reneighbor = update->ntimestep;
}

double FixGrowRadius::max_rad(int type)
{
  double largest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->type[i] == type) largest = std::max(largest, atom->radius[i]);
  return max_over_ranks(largest, world) / factor_;
}

double FixGrowRadius::min_rad(int)
{
  return 0.0;
}

void FixGrowRadius::write_restart(FILE* file)
{
  if (comm->me == 0) write_block(file, {factor_, static_cast<double>(begin_)});
}

void FixGrowRadius::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    factor_ = block.take();
    begin_ = static_cast<LAMMPS_NS::bigint>(block.take());
    next_reneighbor = begin_ + 1;
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
