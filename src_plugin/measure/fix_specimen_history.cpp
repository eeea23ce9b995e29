#include "measure/fix_specimen_history.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "host/say_understood.h"
#include "servo/find_platens.h"

#include <cstring>

namespace encased_column {

const KeywordTable FixSpecimenHistory::keywords{
    {"platens", 2, "-", "IDs of the upper and the lower `fix servo/platen`"},
    {"side", 1, "-", "ID of the cylinder or sleeve around the specimen"},
    {"motion", 1, "-", "ID of the `fix motion` that moves the grains"},
    {"every", 1, "steps", "steps between rows, a multiple of the motion's `every` (default 200)"},
    {"file", 1, "-", "name of the CSV file (default history.csv)"},
    {"reference", 0, "-", "with `fix_modify`: strains, works and losses count from here on"},
};

FixSpecimenHistory::FixSpecimenHistory(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this),
      file_("", {})
{
  try {
    const Options options = keywords.read(narg, arg);
    for (int n = 0; n < 2; ++n) platen_ids_[n] = options.all("platens").front()[n];
    side_id_ = options.word("side");
    motion_id_ = options.word("motion");
    nevery = static_cast<int>(options.integer("every", 1, 200));
    file_ = CsvSeries(files_.file(options, "file", "history.csv"), columns());
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  vector_flag = 1;
  row_.assign(columns().size(), 0.0);
  size_vector = static_cast<int>(row_.size());
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
    FixServoPlaten* platens[2];
    find_platens(lmp, platen_ids_, platens);
    top_ = platens[0];
    bottom_ = platens[1];
    side_ = find_fix<SpecimenSide>(lmp, "side", side_id_, "cylinder or sleeve");
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
  clear_sums();
}

void FixSpecimenHistory::pre_force(int)
{
  setting_up_ = false;
  if (wants_contacts(update->ntimestep)) clear_sums();
}

// The first row is the state before the first step. The motion weighed the grains when it was set
// up itself, perhaps before gravity was.
void FixSpecimenHistory::setup(int)
{
  if (reference_.height != 0.0 && !reference_wanted_) return;
  motion_->weigh_equilibrium();
  reference_wanted_ = true;
  take_sample();
  write_row();
}

void FixSpecimenHistory::end_of_step()
{
  take_sample();
  write_row();
}

void FixSpecimenHistory::write_row()
{
  if (comm->me == 0 && !file_.append(row_)) files_.stop(file_.path());
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

double FixSpecimenHistory::compute_vector(int n)
{
  return row_.at(n);
}

namespace {

/// In a restart file; the last row follows.
struct Saved {
  SpecimenState reference;
  EnergyAccount start;
  ContactLosses losses;
};

}  // namespace

void FixSpecimenHistory::write_restart(FILE* file)
{
  double losses[3] = {contact_losses.friction, contact_losses.rolling, contact_losses.dashpots};
  sum_over_ranks(losses, 3, world);
  if (comm->me != 0) return;
  const Saved saved{reference_, energy_start_, {losses[0], losses[1], losses[2]}};
  const int size = static_cast<int>(sizeof(Saved) + row_.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, file);
  fwrite(&saved, sizeof(Saved), 1, file);
  fwrite(row_.data(), sizeof(double), row_.size(), file);
}

// A run may have gone on after its last restart file was written: those rows come again.
void FixSpecimenHistory::restart(char* buffer)
{
  Saved saved;
  std::memcpy(&saved, buffer, sizeof(Saved));
  reference_ = saved.reference;
  energy_start_ = saved.start;
  std::memcpy(row_.data(), buffer + sizeof(Saved), row_.size() * sizeof(double));
  if (comm->me != 0) return;
  contact_losses = saved.losses;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
}

}  // namespace encased_column
