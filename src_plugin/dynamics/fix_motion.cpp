// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/fix_motion.h"

#include "core/input_error.h"
#include "dynamics/read_mass_rule.h"
#include "host/messages.h"
#include "host/restart_block.h"
#include "host/run_clock.h"

#include <utility>

namespace encased_column {

FixMotion::FixMotion(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : GrainNumberFix(lmp, narg, arg, mass_scaling.inertial_masses())
{
  try {
    const Options options = keywords.read(narg, arg);
    settings_ = MotionSettings::read(options);
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  time_integrate = time_depend = 1;  // contacts remember step numbers
  restart_global = vector_flag = global_freq = 1;
  size_vector = 7;
  extvector = 0;
  force_reneighbor = comm_forward = 1;
}

int FixMotion::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    settings_.modify(options, id);
    say_understood(lmp, *this, options, "fix_modify");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

void FixMotion::init()
{
  motion_.damping = settings_.damping;
  motion_.free_speed_square = settings_.free_speed * settings_.free_speed;
  MassScaling::Rule& rule = mass_scaling.rule;
  rule.step = settings_.step;
  rule.safety = settings_.safety;
  try {
    read_mass_rule(lmp, rule);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  if (!(rule == found_with_)) masses_ = Masses::wanted_in_set_up;
  found_with_ = rule;
  if (rule.scales())
    update->dt = rule.step;
  else if (masses_ != Masses::wanted_in_set_up && found_.stable_step > 0.0)
    update->dt = found_.stable_step;
  stage_ = Stage::set_up;
  watchers_.find(lmp, this);
}

StepGrains FixMotion::grains() const
{
  if (atom->nlocal == 0) return {};
  return {{atom->v[0], atom->omega[0], atom->radius, atom->rmass, atom->nlocal},
          atom->x[0],
          atom->f[0],
          atom->torque[0],
          igroup == 0 ? nullptr : atom->mask,
          groupbit};
}

void FixMotion::setup_pre_force(int)
{
  stage_ = Stage::set_up;
  force_start_.take_over(lmp, this, watchers_.look_always());
  list_timing.take_over(lmp, this);
  masses_ = on_any_rank(masses_ == Masses::wanted_in_set_up || made_grains_, world)
                ? Masses::wanted_in_set_up
                : Masses::found;
  made_grains_ = false;
  resume_time(lmp, time_of_restart_);
  pre_force(0);
}

// Where a deck's run ends, or a restart file is written, must not change the motion: a set-up alone
// finds no masses again. Walls that stand behind this fix add contacts and forces only after it:
// what `run 0` shows is found here, what the first step uses at its start.
// The host calls set_arrays() at the first set-up of a new fix, but not of one that comes from a
// restart file: there the file says so.
void FixMotion::setup(int)
{
  if (std::exchange(restored_made_grains_, false)) made_grains_ = true;
  if (masses_ == Masses::wanted_in_set_up) find_all_in_set_up();
}

void FixMotion::find_all_in_set_up()
{
  admit_new_grains();
  find_masses();
  compute_unbalanced_ratio();
  set_step();
}

/// Outside a step, when no grain has moved yet since its last kick.
void FixMotion::admit_new_grains()
{
  mass_scaling.begin_step(grains(), false);
  mass_scaling.admit_new_grains();
}

void FixMotion::find_masses()
{
  const MassScaling::Found found = mass_scaling.set_masses();
  motion_.loss += mass_scaling.take_loss();
  found_ = {min_over_ranks(found.stable_step, world), max_over_ranks(found.largest_factor, world)};
}

void FixMotion::set_step()
{
  if (mass_scaling.rule.scales() || atom->natoms == 0) return;
  update->update_time();  // with the step that was made
  update->dt = found_.stable_step;
}

void FixMotion::compute_unbalanced_ratio()
{
  ForceSums sums = loads_.sums();
  const StepGrains g = grains();
  const double largest_here =
      sums.add_grains({g.force, loads_.load(g.count), g.mass, force_start_.gravity().norm(),
                       atom->mask, groupbit, g.count});
  const double largest = max_over_ranks(largest_here, world);
  sum_over_ranks(&sums.unbalanced, sizeof(ForceSums) / sizeof(double), world);
  if (!sums.is_finite())
    error->fix_error(
        FLERR, this,
        ("the forces on the grains are not numbers at step " + std::to_string(update->ntimestep) +
         ", go back to the last restart file with a smaller step")
            .c_str());
  ratio_ = encased_column::compute_unbalanced_ratio(sums, largest);
}

void FixMotion::initial_integrate(int)
{
  if (masses_ == Masses::wanted_in_set_up) {
    complete_step();  // with the masses and the step it was made with
    find_all_in_set_up();
    masses_ = Masses::found;
  }
  stage_ = Stage::in_steps;
  if (made_grains_) admit_new_grains();  // made at the end of a step
  motion_.begin_step(grains(), mass_scaling, update->dt, force_start_.gravity(),
                     force_start_.weight());
  force_start_.set_started();
  list_timing.ask(lmp, this, motion_.longest_way);
}

// New grains come with new lists, and maybe on one rank alone.
void FixMotion::pre_force(int)
{
  const bool new_lists = neighbor->ago == 0;
  mass_scaling.begin_step(grains(), stage_ == Stage::in_steps);
  if (new_lists) {
    list_timing.start(lmp, this, stage_ == Stage::set_up);
    mass_scaling.admit_new_grains();
    if (on_any_rank(made_grains_, world)) masses_ = Masses::wanted_in_step;
    made_grains_ = false;
  }
  if (force_start_.is_due(new_lists) && atom->nlocal)
    start_sums(grains(), 0, atom->nlocal, *force_start_.weight());
  if (!wants_contacts(update->ntimestep)) return;
  mass_scaling.clear_contacts();
  loads_.clear(atom->nlocal);
}

void FixMotion::add_contact(const Contact& contact)
{
  mass_scaling.add_contact(contact.i, contact.j, contact.normal, contact.normal_stiffness,
                           contact.shear_stiffness);
  loads_.add(contact.i, contact.j, contact.force.norm(), contact.share);
}

// Masses first: the last half kick is made with them.
void FixMotion::final_integrate()
{
  motion_.end_step();
  const bool finds = wants_contacts(update->ntimestep);
  if (!finds && !watchers_.look_now(lmp)) return;
  if (finds) find_masses();
  complete_step();
  if (!finds) return;
  masses_ = Masses::found;
  compute_unbalanced_ratio();
  set_step();
}

void FixMotion::post_run()
{
  complete_step();
  motion_.damping = settings_.damping;
  force_start_.give_back(lmp);
  list_timing.give_back(lmp, this);
}

/// In a restart file, in this order.
std::vector<double*> FixMotion::saved()
{
  return {&found_.largest_factor, &found_.stable_step, &ratio_.average,
          &ratio_.maximum,        &ratio_.contacts,    &ratio_.bearing,
          &found_with_.step,      &found_with_.safety, &found_with_.stiffest_material};
}

// Called before the host packs the grains: what a signal asks for comes at any step.
void FixMotion::write_restart(FILE* file)
{
  complete_step();
  const bool made_grains = on_any_rank(made_grains_, world);
  const bool wanted = made_grains || masses_ == Masses::wanted_in_set_up;
  std::vector<double> numbers{update->get_cur_time(), damping_loss(), wanted ? 1.0 : 0.0,
                              made_grains ? 1.0 : 0.0, found_with_.rolling ? 1.0 : 0.0};
  if (comm->me != 0) return;
  for (const double* number : saved()) numbers.push_back(*number);
  write_block(file, numbers, "");
}

void FixMotion::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    time_of_restart_ = block.take();
    const double loss = block.take();
    motion_.loss = comm->me == 0 ? loss : 0.0;
    masses_ = block.take() > 0.0 ? Masses::wanted_in_set_up : Masses::found;
    restored_made_grains_ = block.take() > 0.0;
    found_with_.rolling = block.take() > 0.0;
    for (double* number : saved()) *number = block.take();
    made_grains_ = false;  // none of those in the file is new
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
