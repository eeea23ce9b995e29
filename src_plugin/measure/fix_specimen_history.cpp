// SPDX-License-Identifier: GPL-2.0-only
#include "measure/fix_specimen_history.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "host/find_fix.h"
#include "host/gravity.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"
#include "measure/see_contact.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

const KeywordTable FixSpecimenHistory::keywords{
    {"platens", 2, "-", "IDs of the upper and the lower `fix servo/platen`"},
    {"side", 1, "-", "ID of the cylinder or sleeve around the specimen"},
    {"motion", 1, "-", "ID of the `fix motion` that moves the grains"},
    {"every", 1, "steps", "steps between rows, a multiple of the motion's `every` (default 200)"},
    {"file", 1, "-", "name of the CSV file (default history.csv)"},
    {"reference", 0, "-", "with `fix_modify`: strains, works and losses count from here on"},
};

std::vector<TableText> FixSpecimenHistory::tables()
{
  return {{"history.csv", texts_of(specimen_columns())}};
}

FixSpecimenHistory::FixSpecimenHistory(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      platens_(lmp),
      side_(lmp),
      files_(lmp, *this),
      file_("", {})
{
  try {
    const Options options = keywords.read(narg, arg);
    platens_.read(options);
    side_.name("side", options.word("side"), "cylinder or sleeve");
    motion_id_ = options.word("motion");
    nevery = static_cast<int>(options.integer("every", 1, 200));
    file_ = CsvSeries(files_.file(options, "file", "history.csv"), headings_of(specimen_columns()));
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  vector_flag = 1;
  batch_.assign(specimen_columns().size(), 0.0);
  size_vector = static_cast<int>(batch_.size());
  global_freq = 1;
  extvector = 0;
}

int FixSpecimenHistory::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_FORCE | END_OF_STEP;
}

void FixSpecimenHistory::init()
{
  most_grains_ = atom->natoms;
  try {
    platens_.find();
    side_.find();
    motion_ = find_fix<FixMotion>(lmp, "motion", motion_id_, "fix motion");
    files_.check_host();
    if (nevery % motion_->every() != 0)
      throw InputError("'every' must be a multiple of the 'every' of fix " + motion_id_ +
                       ", found " + std::to_string(nevery) + " and " +
                       std::to_string(motion_->every()) + ", write for example 'every " +
                       std::to_string(4 * motion_->every()) + "'");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

bool FixSpecimenHistory::wants_contacts(LAMMPS_NS::bigint step) const
{
  return setting_up_ || step % nevery == 0;
}

void FixSpecimenHistory::setup_pre_force(int)
{
  setting_up_ = true;
  start_sample();
}

void FixSpecimenHistory::pre_force(int)
{
  setting_up_ = false;
  if (wants_contacts(update->ntimestep)) start_sample();
}

void FixSpecimenHistory::start_sample()
{
  contacts_of_.start(atom->nlocal);
  sums_.start(specimen().window(), side_->axis());
}

void FixSpecimenHistory::add_contact(const Contact& contact)
{
  contacts_of_.add(contact);
  sums_.add(see_contact(contact, contacts_of_, *atom));
}

// The first row is the state before the first step. The motion computed the masses when it was set
// up itself, perhaps before gravity was.
void FixSpecimenHistory::setup(int)
{
  if (before_.state.height != 0.0 && !reference_wanted_) return;
  motion_->compute_unbalanced_ratio();
  reference_wanted_ = true;
  take_sample();
  write_row();
}

void FixSpecimenHistory::end_of_step()
{
  take_sample();
  write_row();
}

SpecimenMoment FixSpecimenHistory::now()
{
  const SpecimenSums::Numbers& sums = sums_.numbers();
  return {specimen().state(),
          {specimen().platens().work(), side_->work(), sums.weight_height,
           sums.elastic + side_->stored_energy(), sums.kinetic + side_->kinetic_energy(),
           sums.friction, sums.rolling, sums.dashpots,
           motion_->damping_loss() + side_->damping_loss(), side_->yielding_loss()}};
}

void FixSpecimenHistory::add_grains()
{
  const Vec3 gravity = gravity_of(lmp);
  for (int i = 0; i < atom->nlocal; ++i)
    sums_.add({as_vec3(atom->x[i]), as_vec3(atom->v[i]), as_vec3(atom->omega[i]), atom->radius[i],
               atom->rmass[i], motion_->inertial_mass(i), contacts_of_[i]},
              gravity);
  SpecimenSums::Numbers& sums = sums_.numbers();
  sums.friction = contact_losses.friction;
  sums.rolling = contact_losses.rolling;
  sums.dashpots = contact_losses.dashpots;
  sum_over_ranks(sums_.first(), SpecimenSums::count, world);
}

void FixSpecimenHistory::take_sample()
{
  add_grains();
  check_grains(before_.state.height == 0.0);
  SpecimenSample sample{};
  sample.now = now();
  if (reference_wanted_) {
    before_ = sample.now;
    balance_.start(before_.energy);
  }
  reference_wanted_ = false;
  sample.step = static_cast<double>(update->ntimestep);
  sample.before = before_;
  sample.sums = sums_.numbers();
  sample.strain_rate = specimen().axial_strain_rate();
  sample.unbalanced_ratio = motion_->unbalanced_ratio();
  sample.energy_error = balance_.error(sample.now.energy);
  batch_.clear();
  add_numbers(specimen_columns(), sample, batch_);
}

// A grain that left, or a number that is none, must not pass for a result.
void FixSpecimenHistory::check_grains(bool is_first)
{
  const SpecimenSums::Numbers& sums = sums_.numbers();
  const std::string at_step = " at step " + std::to_string(update->ntimestep);
  const auto stop = [this](const std::string& reason) {
    error->fix_error(FLERR, this, reason.c_str());
  };
  if (!std::isfinite(sums.kinetic) || !std::isfinite(sums.elastic))
    stop("the energy of the grains is not a number" + at_step +
         ", go back to the last restart file with a smaller step");
  // The host's own count forgets grains that `thermo_modify lost ignore` lets go.
  const auto grains = static_cast<LAMMPS_NS::bigint>(sums.grains);
  most_grains_ = std::max(most_grains_, grains);
  if (grains < most_grains_)
    stop("of " + std::to_string(most_grains_) + " grains " + std::to_string(grains) + " are left" +
         at_step + ", enlarge the box or slow the walls");
  const double outside = sum_over_ranks(
      atom->nlocal == 0 ? 0.0 : specimen().count_outside(atom->x[0], atom->nlocal), world);
  if (outside > 0.0)
    stop(std::to_string(static_cast<long>(outside)) + " grains are outside the walls" + at_step +
         (is_first ? ", where the history begins, which takes all grains of the box for one "
                     "specimen: delete those that do not belong to it or set the walls about them"
                   : ", slow the walls or raise the contact modulus"));
}

void FixSpecimenHistory::write_row()
{
  if (comm->me == 0 && !file_.append(batch_)) files_.stop(file_.path());
}

int FixSpecimenHistory::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    if (!options.has("reference") || narg != 1)
      throw InputError("'fix_modify " + std::string(id) + "' takes 'reference' only, found '" +
                       joined({arg, arg + narg}) + "', write 'fix_modify " + id + " reference'");
    reference_wanted_ = true;
    file_.start_anew();
    say_understood(lmp, *this, options, "fix_modify");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

/// What strains and works count from, the energy that took part, the losses, the last row.
void FixSpecimenHistory::write_restart(FILE* file)
{
  double losses[3] = {contact_losses.friction, contact_losses.rolling, contact_losses.dashpots};
  sum_over_ranks(losses, 3, world);
  if (comm->me != 0) return;
  std::vector<double> numbers(before_.first(), before_.first() + SpecimenMoment::count);
  numbers.push_back(balance_.most());
  numbers.insert(numbers.end(), losses, losses + 3);
  numbers.insert(numbers.end(), batch_.begin(), batch_.end());
  write_block(file, numbers, "");
}

// A run may have gone on after its last restart file was written: those rows come again.
void FixSpecimenHistory::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    block.take(before_.first(), SpecimenMoment::count);
    balance_.resume(before_.energy, block.take());
    const double friction = block.take(), rolling = block.take(), dashpots = block.take();
    block.take(batch_.data(), batch_.size());
    if (comm->me != 0) return;
    contact_losses = {friction, rolling, dashpots};
    if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
