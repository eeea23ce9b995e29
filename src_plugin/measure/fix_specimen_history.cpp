#include "measure/fix_specimen_history.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "host/restart_block.h"
#include "host/stop_run.h"
#include "output/output_places.h"
#include "servo/find_platens.h"

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
      file_("", {})
{
  try {
    const Options options = keywords.read(narg, arg);
    for (int n = 0; n < 2; ++n) platen_ids_[n] = options.all("platens").front()[n];
    side_id_ = options.word("side");
    motion_id_ = options.word("motion");
    nevery = static_cast<int>(options.integer("every", 1, 200));
    const std::string file = options.word("file", "history.csv");
    require_writable(lmp, "file", file, file);
    file_ = CsvSeries(file, columns());
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

void FixSpecimenHistory::write_row()
{
  if (comm->me == 0 && !file_.append(row_)) stop_writing();
}

void FixSpecimenHistory::stop_writing() const
{
  stop_from_one_rank(lmp, ("cannot write '" + file_.path() + "', free some space"));
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
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

double FixSpecimenHistory::compute_vector(int n)
{
  return row_.at(n);
}

void FixSpecimenHistory::write_restart(FILE* file)
{
  double losses[3] = {contact_losses.friction, contact_losses.rolling, contact_losses.dashpots};
  sum_over_ranks(losses, 3, world);
  if (comm->me != 0) return;
  const SpecimenState& r = reference_;
  const EnergyAccount& e = balance_.at_start();
  std::vector<double> numbers{r.height,       r.volume,        r.radius[0],     r.radius[1],
                              r.radius[2],    r.stress_top,    r.stress_bottom, r.confining_stress,
                              e.work_platens, e.work_side,     e.work_gravity,  e.elastic,
                              e.kinetic,      e.friction,      e.rolling,       e.dashpots,
                              e.damping,      balance_.most(), losses[0],       losses[1],
                              losses[2]};
  numbers.insert(numbers.end(), row_.begin(), row_.end());
  write_block(file, numbers, "");
}

// A run may have gone on after its last restart file was written: those rows come again.
void FixSpecimenHistory::restart(char* buffer)
{
  RestartBlock block(buffer);
  SpecimenState& r = reference_;
  EnergyAccount e;
  ContactLosses losses;
  double most;
  for (double* number : {&r.height,       &r.volume,     &r.radius[0],     &r.radius[1],
                         &r.radius[2],    &r.stress_top, &r.stress_bottom, &r.confining_stress,
                         &e.work_platens, &e.work_side,  &e.work_gravity,  &e.elastic,
                         &e.kinetic,      &e.friction,   &e.rolling,       &e.dashpots,
                         &e.damping,      &most,         &losses.friction, &losses.rolling,
                         &losses.dashpots})
    *number = block.take();
  balance_.resume(e, most);
  block.take(row_.data(), row_.size());
  if (comm->me != 0) return;
  contact_losses = losses;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) stop_writing();
}

}  // namespace encased_column
