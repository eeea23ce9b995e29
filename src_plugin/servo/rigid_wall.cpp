#include "servo/rigid_wall.h"

#include "core/input_error.h"
#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "host/wall_mover.h"

#include <cstring>

namespace encased_column {

const std::vector<Keyword>& rigid_wall_keywords()
{
  static const std::vector<Keyword> keywords{
    {"mesh", 1, "-", "ID of the `fix mesh/surface` that is the wall"},
    {"hold", 0, "-", "stands still (default)"},
    {"velocity", 1, "m/s", "moves at this speed, positive towards the specimen"},
    {"servo", 1, "Pa", "is driven so that the stress on it is this, zero or larger"},
    {"ramp", 1, "steps", "with `servo`: the target grows linearly from the stress now, in so many steps"},
    {"gain", 1, "-", "fraction of the missing force closed per step, above 0 to 0.8 (default 0.8)"},
    {"speed_limit", 1, "m/s", "largest servo speed (default 1e-4 of the wall's radius per step)"},
  };
  return keywords;
}

RigidWall::RigidWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg)
{
  restart_global = 1;
}

RigidWall::~RigidWall()
{
  if (mover_ && modify->find_fix(mesh_id_.c_str()) >= 0) mover_->pre_delete();
}

void RigidWall::read_motion(const Options& options)
{
  if (options.has("mesh")) {
    mesh_id_ = options.word("mesh");
    mesh_ = find_fix<LAMMPS_NS::FixMeshSurface>(lmp, "mesh", mesh_id_, "fix mesh/surface");
  }
  if (options.has("hold") + options.has("velocity") + options.has("servo") > 1)
    throw InputError("a wall does one of 'hold', 'velocity' and 'servo', found more than one, write one of them");
  if (options.has("ramp") && !options.has("servo"))
    throw InputError("'ramp' goes with 'servo', found it alone, write 'servo STRESS ramp STEPS'");
  gain_ = options.between("gain", 1e-3, 0.8, gain_);
  if (options.has("speed_limit")) speed_limit_ = options.positive("speed_limit");
  if (options.has("hold")) drive_ = Drive::hold;
  if (options.has("velocity")) {
    drive_ = Drive::speed;
    speed_ = options.number("velocity");
  }
  if (options.has("servo")) {
    ramp_from_ = measured_ ? load_.force / loaded_area() : 0.0;
    ramp_steps_ = options.integer("ramp", 1, 0);
    ramp_start_ = update->ntimestep;
    target_ = options.not_negative("servo", 0.0);
    drive_ = Drive::stress;
  }
}

int RigidWall::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE;
}

void RigidWall::init()
{
  try {
    mesh_ = find_fix<LAMMPS_NS::FixMeshSurface>(lmp, "mesh", mesh_id_, "fix mesh/surface");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  if (!mover_) mover_ = std::make_unique<WallMover>(lmp, mesh_);
}

void RigidWall::setup_pre_force(int)
{
  wall_contacts.clear();
  measure(*mover_);
  measured_ = true;
}

void RigidWall::pre_force(int)
{
  wall_contacts.clear();
}

void RigidWall::setup(int)
{
  take_load();
}

void RigidWall::take_load()
{
  const WallLoad local = local_load();
  double sums[2] = {local.force, local.stiffness};
  sum_over_ranks(sums, 2, world);
  load_ = {sums[0], sums[1]};
}

double RigidWall::target_now() const
{
  const LAMMPS_NS::bigint done = update->ntimestep - ramp_start_;
  if (done >= ramp_steps_) return target_;
  return ramp_from_ + (target_ - ramp_from_) * static_cast<double>(done) / static_cast<double>(ramp_steps_);
}

void RigidWall::choose_speed()
{
  if (drive_ == Drive::hold) speed_ = 0.0;
  if (drive_ == Drive::stress)
    speed_ = servo_speed(load_, target_now(), loaded_area(), gain_, update->dt,
                         speed_limit_ > 0.0 ? speed_limit_ : usual_speed_limit());
}

// The load is read here and not in setup(): walls behind this fix in the deck are set up later.
void RigidWall::initial_integrate(int)
{
  take_load();
  force_before_ = load_.force;
  choose_speed();
  advance(*mover_, speed_ * update->dt);
}

// Trapezoid of the force over the step: the work a spring between wall and grain really takes.
void RigidWall::final_integrate()
{
  take_load();
  work_ += 0.5 * (force_before_ + load_.force) * speed_ * update->dt;
}

int RigidWall::modify_param(int narg, char** arg)
{
  try {
    const Options options = table().read(narg, arg, 0);
    if (options.has("mesh"))
      throw InputError("'mesh' cannot change, found 'mesh " + options.word("mesh") + "', make a new fix");
    read_motion(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

void RigidWall::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(&work_, sizeof(double), 1, file);
}

void RigidWall::restart(char* buffer)
{
  std::memcpy(&work_, buffer, sizeof(double));
}

}  // namespace encased_column
