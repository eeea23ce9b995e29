// SPDX-License-Identifier: GPL-2.0-only
#include "packing/fix_grow_radius.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"
#include "packing/grain_volume.h"
#include "packing/growth_end.h"
#include "packing/growth_law.h"

#include <algorithm>
#include <cstdio>

namespace encased_column {

FixGrowRadius::FixGrowRadius(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      begin_(update->ntimestep),
      platens_(lmp),
      side_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    settings_ = GrowthSettings::read(options);
    if (settings_.goal) {
      control_.emplace(*settings_.goal, settings_.start, settings_.stages);
      platens_.read(options);
      side_.name("side", options.word("side"), "cylinder or sleeve");
    }
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  factor_ = settings_.start;
  force_reneighbor = 1;
  next_reneighbor = begin_ + 1;
  rad_mass_vary_flag = 1;
  restart_global = 1;
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 5;
  extvector = 0;
  global_freq = 1;
}

int FixGrowRadius::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return control_ ? INITIAL_INTEGRATE | PRE_FORCE : INITIAL_INTEGRATE;
}

void FixGrowRadius::init()
{
  if (!control_) return;
  try {
    find_specimen();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixGrowRadius::find_specimen()
{
  platens_.find();
  side_.find();
  const auto motions = fixes_that_are<FixMotion>(lmp);
  if (motions.size() != 1)
    throw InputError("'stress' needs one 'fix motion', found " + std::to_string(motions.size()) +
                     ", write 'fix move all motion'");
  motion_ = motions.front();
  if (settings_.steps_per_stage % motion_->every() != 0)
    throw InputError("'relax' must be a multiple of the 'every' of fix " +
                     std::string(motion_->id) + " with 'stress', found " +
                     std::to_string(settings_.steps_per_stage) + " and " +
                     std::to_string(motion_->every()) + ", write for example 'relax " +
                     std::to_string(motion_->every()) + "'");
}

bool FixGrowRadius::wants_contacts(LAMMPS_NS::bigint step) const
{
  return control_ && (step - begin_) % settings_.steps_per_stage == 0;
}

void FixGrowRadius::start_sums()
{
  if (wants_contacts(update->ntimestep)) sums_ = {};
}

void FixGrowRadius::add_contact(const Contact& contact)
{
  sums_.add(contact.share, -contact.force.dot(contact.normal), contact.normal_stiffness,
            contact.length);
}

// Before the host decides on its lists, so that a stage and the list that knows it share a step.
void FixGrowRadius::initial_integrate(int)
{
  const LAMMPS_NS::bigint done = update->ntimestep - begin_ - 1;
  if (done % settings_.steps_per_stage != 0) return;
  if (control_) {
    decide();
  } else if (factor_ != 1.0) {
    const double stage = static_cast<double>(done / settings_.steps_per_stage + 1);
    grow_to(growth_factor(settings_.start, stage / static_cast<double>(settings_.stages)));
  }
}

void FixGrowRadius::decide()
{
  if (control_->stage() != GrowthControl::Stage::grows) return;
  found_ = look();
  control_->decide(found_);
  friction_factor = control_->friction_factor();
  if (control_->stage() != GrowthControl::Stage::grows)
    report_end();
  else if (control_->radius_factor() != factor_)
    grow_to(control_->radius_factor());
}

PackingState FixGrowRadius::look()
{
  double sums[2] = {sums_.virial, sums_.stiffness};
  sum_over_ranks(sums, 2, world);
  const ContactSums all{sums[0], sums[1]};
  const double space = volume();
  return {all.mean_stress(space), all.bulk_stiffness(space), motion_->unbalanced_ratio().average};
}

void FixGrowRadius::grow_to(double factor)
{
  const double ratio = factor / factor_;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    atom->radius[i] *= ratio;
    atom->rmass[i] *= ratio * ratio * ratio;
  }
  factor_ = factor;
  next_reneighbor = update->ntimestep;
}

double FixGrowRadius::volume() const
{
  return Specimen(platens_.now(), *side_).volume();
}

double FixGrowRadius::porosity_at(double solid) const
{
  if (solid == 0.0 || !platens_.are_there() || !side_.is_there()) return 0.0;
  double grains = 0.0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) grains += grain_volume(2.0 * atom->radius[i]);
  grains = sum_over_ranks(grains, world);
  return porosity(grains * solid / control_->solid(), volume());
}

// The same on all ranks.
void FixGrowRadius::report_end()
{
  const GrowthEnd end{control_->stage(),
                      *settings_.goal,
                      found_,
                      friction_factor,
                      porosity_at(control_->solid()),
                      porosity_at(1.0),
                      porosity_at(control_->loosest()),
                      porosity_at(control_->densest())};
  const std::string words = end.in_words();
  if (!end.is_good()) error->fix_error(FLERR, this, words.c_str());
  if (comm->me != 0) return;
  for (FILE* out : {screen, logfile})
    if (out) std::fprintf(out, "fix %s: %s\n", id, words.c_str());
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

double FixGrowRadius::compute_vector(int n)
{
  const bool grows = control_ ? control_->stage() == GrowthControl::Stage::grows : factor_ != 1.0;
  switch (n) {
    case 0:
      return grows ? 1.0 : 0.0;
    case 1:
      return found_.mean_stress;
    case 2:
      return friction_factor;
    case 3:
      return control_ ? porosity_at(control_->loosest()) : 0.0;
    default:
      return control_ ? porosity_at(control_->densest()) : 0.0;
  }
}

void FixGrowRadius::write_restart(FILE* file)
{
  std::vector<double> numbers{factor_, static_cast<double>(begin_)};
  if (control_) {
    for (const double number : control_->state()) numbers.push_back(number);
    numbers.push_back(found_.mean_stress);
  }
  if (comm->me == 0) write_block(file, numbers);
}

void FixGrowRadius::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    factor_ = block.take();
    begin_ = static_cast<LAMMPS_NS::bigint>(block.take());
    if (control_) {
      std::array<double, GrowthControl::numbers> state;
      block.take(state.data(), state.size());
      control_->restore(state);
      friction_factor = control_->friction_factor();
      found_.mean_stress = block.take();
    }
    next_reneighbor = begin_ + 1;
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
