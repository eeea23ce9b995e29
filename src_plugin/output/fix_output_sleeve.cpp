// SPDX-License-Identifier: GPL-2.0-only
#include "output/fix_output_sleeve.h"

#include "core/input_error.h"
#include "files/vtk_files.h"
#include "host/find_fix.h"
#include "host/messages.h"
#include "host/restart_block.h"
#include "output/sleeve_columns.h"
#include "output/sleeve_fields.h"
#include "shell/fix_mesh_surface_shell.h"

#include <numeric>

namespace encased_column {

const KeywordTable FixOutputSleeve::keywords{
    {"sleeve", 1, "-", "ID of the `fix mesh/surface/shell`"},
    {"every", 1, "steps", "one VTK file and one block of the profile every so many steps"},
    {"rows", 1, "steps", "one row of the curves every so many steps (default 200)"},
    {"folder", 1, "-", "folder of the VTK files, created if missing"},
    {"name", 1, "-", "name of the series (default sleeve)"},
    {"profile", 1, "-", "CSV file of the profile over the height (default profile.csv)"},
    {"curves", 1, "-", "CSV file of the curves (default sleeve.csv)"},
};

std::vector<TableText> FixOutputSleeve::tables()
{
  return {{"profile.csv", texts_of(profile_columns())}, {"sleeve.csv", texts_of(sleeve_columns())}};
}

FixOutputSleeve::FixOutputSleeve(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this),
      clock_(lmp),
      profile_("", {}),
      curves_("", {})
{
  try {
    const Options options = keywords.read(narg, arg);
    sleeve_id_ = options.word("sleeve");
    frame_every_ = options.integer("every", 1);
    row_every_ = options.integer("rows", 1, 200);
    nevery = static_cast<int>(std::gcd(frame_every_, row_every_));
    profile_ =
        CsvSeries(files_.file(options, "profile", "profile.csv"), headings_of(profile_columns()));
    curves_ =
        CsvSeries(files_.file(options, "curves", "sleeve.csv"), headings_of(sleeve_columns()));
    series_ = make_series(files_, options, "sleeve");
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
}

void FixOutputSleeve::init()
{
  try {
    sleeve_ = find_fix<FixMeshSurfaceShell>(lmp, "sleeve", sleeve_id_, "fix mesh/surface/shell");
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  rings_.emplace(sleeve_->model());
}

void FixOutputSleeve::setup(int)
{
  clock_.begin_run();
  if (!before_.empty()) return;
  before_ = sleeve_->model().position();
  height_before_ = height();
  write_curves();
  write_frame();
}

void FixOutputSleeve::end_of_step()
{
  if (update->ntimestep % row_every_ == 0) write_curves();
  if (update->ntimestep % frame_every_ == 0) write_frame();
}

double FixOutputSleeve::height() const
{
  const HeightWindow window = sleeve_->window();
  return window.high - window.low;
}

void FixOutputSleeve::write_curves()
{
  const HeightWindow window = sleeve_->window();
  const SleeveCurves now{static_cast<double>(update->ntimestep),
                         axial_strain(),
                         sleeve_->pressure_now(),
                         sleeve_->summary(),
                         sleeve_->axial_force(true),
                         sleeve_->axial_force(false),
                         sleeve_->friction_force(),
                         sleeve_->enclosed_volume(window.low, window.high),
                         sleeve_->stored_energy(),
                         sleeve_->yielding_loss()};
  std::vector<double> row;
  add_numbers(sleeve_columns(), now, row);
  if (comm->me == 0 && !curves_.append(row)) files_.stop(curves_.path());
}

void FixOutputSleeve::write_frame()
{
  sleeve_->share_memory();
  if (comm->me != 0) return;
  std::vector<double> rows;
  for (const ProfilePoint& point : rings_->profile(sleeve_->model(), before_, sleeve_->axis()))
    add_numbers(profile_columns(), {static_cast<double>(update->ntimestep), axial_strain(), point},
                rows);
  if (!profile_.append(rows)) files_.stop(profile_.path());
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  const ShellModel& model = sleeve_->model();
  if (!write_surface(path, model.position(), model.facet(),
                     sleeve_node_fields(model, before_, sleeve_->axis()),
                     sleeve_facet_fields(model)) ||
      !series_->list(clock_.now(), step))
    files_.stop(path);
}

/// Time and height, the positions compared with, then the series as text.
void FixOutputSleeve::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::vector<double> numbers{clock_.now(), height_before_, static_cast<double>(before_.size())};
  for (const Vec3& node : before_) numbers.insert(numbers.end(), node.data(), node.data() + 3);
  write_block(file, numbers, series_->saved());
}

void FixOutputSleeve::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    clock_.restart(block.take());
    height_before_ = block.take();
    before_.resize(static_cast<std::size_t>(block.take()));
    for (Vec3& node : before_) block.take(node.data(), 3);
    if (comm->me != 0) return;
    if (!series_->restore(block.text()))
      files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
    const double step = static_cast<double>(update->ntimestep);
    if (!profile_.go_back_to(step)) files_.stop(profile_.path());
    if (!curves_.go_back_to(step)) files_.stop(curves_.path());
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
