// SPDX-License-Identifier: GPL-2.0-only
#include "measure/fix_measure_sphere.h"

#include "core/input_error.h"
#include "files/vtk_files.h"
#include "host/grains_and_box.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"
#include "measure/see_contact.h"

#include <numeric>

namespace encased_column {

namespace {

/// Fewer and the numbers of a sphere depend on where it stands.
/// Source: the study, section 2.2.2.
constexpr double fewest_grains = 2000.0;

}  // namespace

const KeywordTable FixMeasureSphere::keywords{
    {"sphere", 4, "m", "x, y, z and radius of a sphere that stands still (may be repeated)", true},
    {"stack", 2, "-, m", "number and radius of spheres one above the other between the platens"},
    {"platens", 2, "-", "with `stack`: IDs of the upper and the lower `fix servo/platen`"},
    {"axis", 2, "m", "x and y of the column's axis (default 0 0)"},
    {"every", 1, "steps", "steps between samples (default 1000)"},
    {"file", 1, "-", "CSV file (default spheres.csv)"},
    {"folder", 1, "-", "folder of VTK files, created if missing (default: none are written)"},
    {"frames", 1, "steps",
     "with `folder`: one VTK file every so many steps (default: those of `every`)"},
    {"name", 1, "-", "name of their series (default spheres)"},
};

std::vector<TableText> FixMeasureSphere::tables()
{
  return {{"spheres.csv", texts_of(sphere_columns())}};
}

FixMeasureSphere::FixMeasureSphere(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      platens_(lmp),
      files_(lmp, *this),
      file_("", {}),
      clock_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    sampler_ = SphereSampler(options);
    if (sampler_.has_stack()) platens_.read(options);
    row_every_ = options.integer("every", 1, 1000);
    frame_every_ = options.has("frames") ? options.integer("frames", 1) : row_every_;
    nevery = static_cast<int>(std::gcd(row_every_, frame_every_));
    file_ = CsvSeries(files_.file(options, "file", "spheres.csv"), headings_of(sphere_columns()));
    if (options.has("frames") && !options.has("folder"))
      throw InputError(
          "'frames' goes with 'folder', found it alone, write for example 'folder spheres'");
    if (options.has("folder")) {
      series_ = make_series(files_, options, "spheres");
      options.assume("frames", std::to_string(frame_every_));
    }
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  const std::size_t columns = sphere_columns().size();
  restart_global = 1;
  array_flag = 1;
  size_array_rows = static_cast<int>(sampler_.spheres());
  size_array_cols = static_cast<int>(columns);
  global_freq = 1;
  extarray = 0;
  rows_.assign(sampler_.spheres(), std::vector<double>(columns, 0.0));
}

int FixMeasureSphere::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_FORCE | END_OF_STEP;
}

void FixMeasureSphere::init()
{
  try {
    if (sampler_.has_stack()) platens_.find();
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

bool FixMeasureSphere::wants_contacts(LAMMPS_NS::bigint step) const
{
  return setting_up_ || step % row_every_ == 0 || step % frame_every_ == 0;
}

void FixMeasureSphere::setup_pre_force(int)
{
  setting_up_ = true;
  start_sample();
}

void FixMeasureSphere::pre_force(int)
{
  setting_up_ = false;
  if (wants_contacts(update->ntimestep)) start_sample();
}

void FixMeasureSphere::start_sample()
{
  sampler_.start(box_of(lmp), sampler_.has_stack() ? platens_.now().window() : HeightWindow());
  contacts_of_.start(atom->nlocal);
}

void FixMeasureSphere::add_contact(const Contact& contact)
{
  contacts_of_.add(contact);
  sampler_.add(see_contact(contact, contacts_of_, *atom));
}

// The first row is the state before the first step.
void FixMeasureSphere::setup(int)
{
  clock_.begin_run();
  if (sampled_) return;
  take_sample();
  write_row();
  write_frame();
}

void FixMeasureSphere::end_of_step()
{
  if (!wants_contacts(update->ntimestep)) return;
  take_sample();
  if (update->ntimestep % row_every_ == 0) write_row();
  if (update->ntimestep % frame_every_ == 0) write_frame();
}

void FixMeasureSphere::take_sample()
{
  sampled_ = true;
  for (int i = 0; i < atom->nlocal; ++i)
    sampler_.add_grain(as_vec3(atom->x[i]), atom->radius[i], contacts_of_[i]);
  sum_over_ranks(sampler_.sums(), sampler_.size_of_sums(), world);
  for (double& force : sampler_.largest_forces()) force = max_over_ranks(force, world);
  const auto samples = sampler_.samples(static_cast<double>(update->ntimestep));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    rows_[n].clear();
    add_numbers(sphere_columns(), samples[n], rows_[n]);
  }
  warn_of_few_grains(samples);
}

void FixMeasureSphere::warn_of_few_grains(const std::vector<SphereRow>& samples)
{
  for (const SphereRow& sample : samples) {
    if (warned_ || sample.measure.grains >= fewest_grains) continue;
    warned_ = true;
    if (comm->me == 0)
      error->warning(
          FLERR, ("measuring sphere " + in_words(sample.number) + " of fix '" + id + "' holds " +
                  in_words(sample.measure.grains) + " grains at step " +
                  std::to_string(update->ntimestep) +
                  ", take a larger one: below 2000 its numbers depend on where it stands")
                     .c_str());
  }
}

void FixMeasureSphere::write_row()
{
  if (comm->me != 0) return;
  std::vector<double> block;
  for (const std::vector<double>& row : rows_) block.insert(block.end(), row.begin(), row.end());
  if (!file_.append(block)) files_.stop(file_.path());
}

void FixMeasureSphere::write_frame()
{
  if (comm->me != 0 || !series_) return;
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  if (!write_spheres(path, headings_of(sphere_columns()), rows_) ||
      !series_->list(clock_.now(), step))
    files_.stop(path);
}

/// The time and the rows as they are, then the series as text.
void FixMeasureSphere::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::vector<double> numbers{clock_.now()};
  for (const std::vector<double>& row : rows_)
    numbers.insert(numbers.end(), row.begin(), row.end());
  write_block(file, numbers, series_ ? series_->saved() : "");
}

void FixMeasureSphere::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    clock_.restart(block.take());
    for (std::vector<double>& row : rows_) block.take(row.data(), row.size());
    sampled_ = true;
    if (comm->me != 0) return;
    if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
    if (series_ && !series_->restore(block.text()))
      files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
