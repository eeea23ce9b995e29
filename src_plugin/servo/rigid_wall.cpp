// SPDX-License-Identifier: GPL-2.0-only
#include "servo/rigid_wall.h"

#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"

#include "pair_gran.h"

namespace encased_column {

RigidWall::RigidWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : ContactMemoryFix(lmp, narg, arg),
      context_(lmp)
{
  restart_global = 1;
  vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extvector = 0;
}

void RigidWall::read_wall(const Options& options)
{
  const bool on_fix_line = wall_type_ == 0;
  if (on_fix_line) on_fix_line_ = options;
  if (options.has("type") || on_fix_line) {
    wall_type_ = static_cast<int>(options.integer("type", 1));
    material_is_new_ = true;
    if (wall_type_ > atom->ntypes)
      throw InputError("'type' must be one of the " + std::to_string(atom->ntypes) +
                       " atom types, found " + std::to_string(wall_type_) +
                       ", write a smaller one or make room in 'create_box'");
  }
  motion_.read(options, update->ntimestep, stress_now());
  options.assume("type", std::to_string(wall_type_));
  say_understood(lmp, *this, options, on_fix_line ? "fix" : "fix_modify");
}

// A wall that comes from a restart file feels nothing before its set-up: until then, the file
// knows.
double RigidWall::stress_now() const
{
  if (!is_set_up_) return restored_stress_;
  return load().stiffness > 0.0 && has_partners() ? load().stress_on(loaded_area()) : 0.0;
}

int RigidWall::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
}

void RigidWall::init()
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair);
  rolling_ = pair && pair->contact_match("rolling_friction", "epsd2");
  try {
    context_.open(rolling_);
    find_partners();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

// Set-up repeats the forces of the step before: what contacts remember stays as it is.
void RigidWall::setup(int flags)
{
  advance_memory_ = false;
  post_force(flags);
  advance_memory_ = true;
  is_set_up_ = true;
}

// Most steps of a wall that goes its own way need no sum, and no rank then waits for another.
const WallLoad& RigidWall::load() const
{
  if (summed_) return sum_;
  double sums[2] = {own_load_.force, own_load_.stiffness};
  sum_over_ranks(sums, 2, world);
  sum_ = {sums[0], sums[1]};
  summed_ = true;
  return sum_;
}

double RigidWall::work_on_grains() const
{
  return sum_over_ranks(work_.done(), world);
}

void RigidWall::initial_integrate(int)
{
  // The cross section of a sleeve takes a pass over its facets: found only where it counts.
  const bool by_load = motion_.follows_stress();
  speed_ = motion_.speed(update->ntimestep, update->dt, by_load ? load() : WallLoad(),
                         by_load ? loaded_area() : 0.0,
                         by_load ? usual_speed_limit(mean_radius(), update->dt) : 0.0);
  check_reach();
  const double way = speed_ * update->dt;
  work_.begin_step(own_load_.force, way);
  advance(way);
}

// The load is the same on every rank, and so is the end.
void RigidWall::check_reach()
{
  if (!motion_.is_out_of_reach()) return;
  const std::string found =
      "'servo' must be a stress that the grains can bear, found " + in_words(stress_now()) +
      " of " + in_words(motion_.target(update->ntimestep)) + " Pa after " +
      std::to_string(motion_.patience()) + " steps at the speed limit at step " +
      std::to_string(update->ntimestep) +
      ", write a stress in reach, or a larger 'patience' where the way is long";
  error->fix_error(FLERR, this, found.c_str());
}

void RigidWall::final_integrate()
{
  work_.end_step(own_load_.force);
}

int RigidWall::modify_param(int narg, char** arg)
{
  try {
    static const KeywordTable motion_only{WallMotion::keywords(), {}};
    if (load().stiffness > 0.0) find_partners();  // a ramp starts from the stress they give
    read_wall(motion_only.read(narg, arg, 0));
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

// The stress is where a ramp would start.
void RigidWall::write_restart(FILE* file)
{
  std::vector<double> numbers{work_on_grains(), position(), speed_, stress_now()};
  if (comm->me != 0) return;
  for (const double number : motion_.state()) numbers.push_back(number);
  write_block(file, numbers, "");
}

// The wall goes on as it did, but for what the fix line says of its motion.
void RigidWall::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    const double work = block.take();
    work_.restore(comm->me == 0 ? work : 0.0);
    set_position(block.take());
    speed_ = block.take();
    restored_stress_ = block.take();
    std::array<double, WallMotion::numbers> motion;
    block.take(motion.data(), motion.size());
    motion_.restore(motion);
    motion_.read(on_fix_line_, update->ntimestep, restored_stress_);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
