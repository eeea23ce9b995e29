#include "measure/fix_specimen_history.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "dynamics/inertial_number.h"
#include "host/find_fix.h"
#include "host/gravity.h"
#include "host/rank_sums.h"
#include "host/stop_run.h"
#include "measure/coordination.h"
#include "measure/sphere_overlap.h"
#include "output/output_places.h"
#include "servo/find_platens.h"

#include <cmath>
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

namespace {

// One list for header and order of the columns.
const char* const columns[] = {"step [-]",
                               "axial_strain [-]",
                               "stress_top [Pa]",
                               "stress_bottom [Pa]",
                               "confining_stress [Pa]",
                               "deviatoric_stress_top [Pa]",
                               "deviatoric_stress_bottom [Pa]",
                               "mean_stress [Pa]",
                               "volumetric_strain [-]",
                               "height [m]",
                               "radius [m]",
                               "porosity [-]",
                               "porosity_less_overlap [-]",
                               "coordination_number [-]",
                               "coordination_number_bearing [-]",
                               "radial_strain_25 [-]",
                               "radial_strain_50 [-]",
                               "radial_strain_75 [-]",
                               "unbalanced_average [-]",
                               "unbalanced_maximum [-]",
                               "inertial_number [-]",
                               "work_platens [J]",
                               "work_side [J]",
                               "work_gravity [J]",
                               "energy_elastic [J]",
                               "energy_kinetic [J]",
                               "loss_friction [J]",
                               "loss_rolling [J]",
                               "loss_dashpots [J]",
                               "loss_damping [J]",
                               "energy_error [-]",
                               "core_axial_stress [Pa]",
                               "core_radial_stress [Pa]"};
constexpr int column_count = sizeof(columns) / sizeof(columns[0]);

}  // namespace

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
    file_ = CsvSeries(file, {columns, columns + column_count});
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  vector_flag = 1;
  size_vector = column_count;
  global_freq = 1;
  extvector = 0;
  row_.assign(column_count, 0.0);
}

int FixSpecimenHistory::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_FORCE | END_OF_STEP;
}

void FixSpecimenHistory::init()
{
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
  motion_->weigh_equilibrium();
  reference_wanted_ = true;
  take_sample();
  write_row();
}

SpecimenState FixSpecimenHistory::state() const
{
  SpecimenState s;
  const double z_low = bottom_->height(), z_high = top_->height();
  s.height = z_high - z_low;
  s.volume = side_->enclosed_volume(z_low, z_high);
  for (int n = 0; n < 3; ++n) s.radius[n] = side_->radius_at(z_low + 0.25 * (n + 1) * s.height);
  s.stress_top = top_->stress();
  s.stress_bottom = bottom_->stress();
  s.confining_stress = side_->confining_stress();
  return s;
}

void FixSpecimenHistory::take_sample()
{
  const Sums sums = sum_up();
  check_grains(sums);
  now_ = state();
  energy_ = {top_->work_on_grains() + bottom_->work_on_grains(),
             side_->work(),
             sums.weight_height,
             sums.elastic + side_->stored_energy(),
             sums.kinetic + side_->kinetic_energy(),
             sums.friction,
             sums.rolling,
             sums.dashpots,
             motion_->damping_loss() + side_->damping_loss()};
  if (reference_wanted_) take_reference();

  const double confining = now_.confining_stress;
  const double p = mean_stress(0.5 * (now_.stress_top + now_.stress_bottom), confining);
  const double rate = (top_->speed() + bottom_->speed()) / now_.height;
  // Stress of the grains, spread over the room they take up with their share of the voids.
  const double per_volume =
      sums.core_solid > 0.0 ? sums.solid / now_.volume / sums.core_solid : 0.0;
  const ContactCount count{sums.grains, sums.ends, sums.without_contact, sums.with_one_contact};
  const Equilibrium& equilibrium = motion_->equilibrium();
  row_ = {static_cast<double>(update->ntimestep),
          shortening(reference_.height, now_.height),
          now_.stress_top,
          now_.stress_bottom,
          confining,
          deviatoric_stress(now_.stress_top, confining),
          deviatoric_stress(now_.stress_bottom, confining),
          p,
          shortening(reference_.volume, now_.volume),
          now_.height,
          now_.radius[1],
          porosity(sums.solid, now_.volume),
          porosity(sums.solid - sums.shared, now_.volume),
          coordination_number(count),
          bearing_coordination_number(count),
          shortening(reference_.radius[0], now_.radius[0]),
          shortening(reference_.radius[1], now_.radius[1]),
          shortening(reference_.radius[2], now_.radius[2]),
          equilibrium.average,
          equilibrium.maximum,
          p > 0.0 ? inertial_number(rate, sums.diameter / sums.mass, sums.inertia / sums.solid, p)
                  : 0.0,
          energy_.work_platens - energy_start_.work_platens,
          energy_.work_side - energy_start_.work_side,
          energy_.work_gravity - energy_start_.work_gravity,
          energy_.elastic,
          energy_.kinetic,
          energy_.friction - energy_start_.friction,
          energy_.rolling - energy_start_.rolling,
          energy_.dashpots - energy_start_.dashpots,
          energy_.damping - energy_start_.damping,
          energy_error(energy_start_, energy_),
          sums.core_axial * per_volume,
          sums.core_radial * per_volume};
}

void FixSpecimenHistory::take_reference()
{
  reference_ = now_;
  energy_start_ = energy_;
  reference_wanted_ = false;
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
                       std::string(arg[0]) + "'");
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

namespace {

struct Saved {
  SpecimenState reference;
  EnergyAccount start;
  ContactLosses losses;
  double row[column_count];
};

}  // namespace

void FixSpecimenHistory::write_restart(FILE* file)
{
  double losses[3] = {contact_losses.friction, contact_losses.rolling, contact_losses.dashpots};
  sum_over_ranks(losses, 3, world);
  if (comm->me != 0) return;
  Saved saved{reference_, energy_start_, {losses[0], losses[1], losses[2]}, {}};
  std::copy(row_.begin(), row_.end(), saved.row);
  const int size = sizeof(Saved);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(&saved, sizeof(Saved), 1, file);
}

// A run may have gone on after its last restart file was written: those rows come again.
void FixSpecimenHistory::restart(char* buffer)
{
  Saved saved;
  std::memcpy(&saved, buffer, sizeof(Saved));
  reference_ = saved.reference;
  energy_start_ = saved.start;
  row_.assign(saved.row, saved.row + column_count);
  if (comm->me != 0) return;
  contact_losses = saved.losses;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) stop_writing();
}

}  // namespace encased_column
