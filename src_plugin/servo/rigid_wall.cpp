#include "servo/rigid_wall.h"

#include "host/rank_sums.h"
#include "host/restart_block.h"

#include "pair_gran.h"

#include <algorithm>

namespace encased_column {

RigidWall::RigidWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : ContactMemoryFix(lmp, narg, arg),
      desk_(lmp)
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
  drive_.read(options, update->ntimestep, stress_now());
}

double RigidWall::stress_now() const
{
  return load().stiffness > 0.0 && has_partners() ? load().force / loaded_area() : 0.0;
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
    desk_.open(rolling_);
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
  return sum_over_ranks(work_, world);
}

void RigidWall::initial_integrate(int)
{
  // The cross section of a sleeve takes a pass over its facets: found only where it counts.
  const bool by_load = drive_.follows_stress();
  speed_ = drive_.speed(update->ntimestep, update->dt, by_load ? load() : WallLoad(),
                        by_load ? loaded_area() : 0.0, by_load ? usual_speed_limit() : 0.0);
  check_reach();
  force_before_ = own_load_.force;
  way_ = speed_ * update->dt;
  advance(way_);
}

// The load is the same on every rank, and so is the end.
void RigidWall::check_reach()
{
  if (!drive_.is_out_of_reach()) return;
  const std::string found =
      "'servo' must be a stress that the grains can bear, found " + in_words(stress_now()) +
      " of " + in_words(drive_.target(update->ntimestep)) + " Pa after " +
      std::to_string(drive_.patience()) + " steps at the speed limit at step " +
      std::to_string(update->ntimestep) +
      ", write a stress in reach, or a larger 'patience' where the way is long";
  error->fix_error(FLERR, this, found.c_str());
}

// Trapezoid of the force over the way: the work a spring between wall and grain really takes. The
// step may be another by now.
void RigidWall::final_integrate()
{
  work_ += 0.5 * (force_before_ + own_load_.force) * way_;
}

int RigidWall::modify_param(int narg, char** arg)
{
  try {
    static const KeywordTable drive_only{WallDrive::keywords(), {}};
    if (load().stiffness > 0.0) find_partners();  // a ramp starts from the stress they give
    read_wall(drive_only.read(narg, arg, 0));
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

void RigidWall::write_restart(FILE* file)
{
  const WallDrive::State drive = drive_.state();
  std::vector<double> numbers{work_on_grains(), position(), speed_, stress_now()};
  numbers.insert(numbers.end(), drive.begin(), drive.end());
  if (comm->me == 0) write_block(file, numbers, "");
}

// The wall goes on as it did, but for what the fix line says of its drive.
void RigidWall::restart(char* buffer)
{
  RestartBlock block(buffer);
  const double work = block.take();
  work_ = comm->me == 0 ? work : 0.0;
  const double position = block.take();
  speed_ = block.take();
  set_position(position);
  const double stress = block.take();  // where a ramp would start
  WallDrive::State drive;
  block.take(drive.data(), drive.size());
  drive_.resume(drive);
  drive_.read(on_fix_line_, update->ntimestep, stress);
}

}  // namespace encased_column
