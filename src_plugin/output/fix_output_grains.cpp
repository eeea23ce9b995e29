// SPDX-License-Identifier: GPL-2.0-only
#include "output/fix_output_grains.h"

#include "core/input_error.h"
#include "host/grains_and_box.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"
#include "output/grain_track.h"

#include <algorithm>
#include <cstring>

namespace encased_column {

const KeywordTable FixOutputGrains::keywords{
    {"every", 1, "steps", "one file every so many steps"},
    {"folder", 1, "-", "folder of the files, created if missing"},
    {"name", 1, "-", "name of the series (default grains)"},
    {"compress", 1, "-", "yes (default) or no"},
    {"rotation", 1, "-", "yes (default) or no: no array and no cost per step"},
    {"strain_range", 1, "m",
     "range of neighbours for the strain (default 1.5 mean diameters), 0: no array"},
};

FixOutputGrains::FixOutputGrains(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this),
      clock_(lmp)
{
  try {
    read_keywords(narg, arg);
    if (!atom->radius_flag)
      throw InputError("'output/grains' needs grains with a radius, found 'atom_style " +
                       std::string(atom->atom_style) + "', write 'atom_style granular'");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
}

FixOutputGrains::~FixOutputGrains()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixOutputGrains::read_keywords(int narg, char** arg)
{
  const Options options = keywords.read(narg, arg);
  nevery = static_cast<int>(options.integer("every", 1));
  options_.compress = options.choice("compress", {"yes", "no"}, "yes") == "yes";
  options_.rotation = options.choice("rotation", {"yes", "no"}, "yes") == "yes";
  strain_range_ = options.has("strain_range") ? options.not_negative("strain_range", 0.0) : -1.0;
  options_.strain = strain_range_ != 0.0;
  series_ = make_series(files_, options, "grains");
  if (strain_range_ < 0.0)
    options.assume("strain_range", in_words(usual_strain_range) + " mean diameters");
  say_understood(lmp, *this, options);
}

int FixOutputGrains::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return END_OF_STEP | (options_.rotation ? POST_INTEGRATE : 0);
}

void FixOutputGrains::init()
{
  asked_step_ = -1;  // forces are computed again for the same step
  try {
    for (int n = 0; n < modify->nfix; ++n)
      if (options_.strain && modify->fix[n]->box_change_size && box_of(lmp).is_periodic())
        throw InputError("'strain_range' must be 0 in a periodic box whose size changes, found '" +
                         std::string("fix ") + modify->fix[n]->id + "' of style " +
                         modify->fix[n]->style + ", write 'strain_range 0'");
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixOutputGrains::setup(int)
{
  clock_.begin_run();
  if (!written_) write();
}

// The spin in the middle of the step turns a grain from its begin to its end.
void FixOutputGrains::post_integrate()
{
  if (atom->nlocal > 0) track_.turn(atom->nlocal, atom->omega[0], update->dt);
}

int FixOutputGrains::modify_param(int narg, char** arg)
{
  if (std::strcmp(arg[0], "reset") == 0) {
    for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
    return 1;
  }
  if (narg > 1 && std::strcmp(arg[0], "write") == 0 && std::strcmp(arg[1], "now") == 0) {
    write();
    return 2;
  }
  error->fix_error(
      FLERR, this,
      ("'fix_modify " + std::string(id) + "' takes 'reset' or 'write now', found '" +
       joined({arg, arg + narg}) + "', write for example 'fix_modify " + id + " write now'")
          .c_str());
  return 0;
}

// The last step is counted too: `fix_modify ID write now` may follow it.
bool FixOutputGrains::wants_contacts(LAMMPS_NS::bigint step) const
{
  if (written_ && step % nevery != 0 && step != update->laststep) return false;
  if (asked_step_ != step) {
    asked_step_ = step;
    contacts_of_.start(atom->nlocal);
  }
  return true;
}

bool FixOutputGrains::contacts_are_counted() const
{
  return asked_step_ == update->ntimestep && contacts_of_.grains() == atom->nlocal;
}

GrainRecord FixOutputGrains::record_of(int i) const
{
  GrainRecord grain{};
  grain.id = atom->tag[i];
  grain.type = atom->type[i];
  grain.coordination_number = contacts_are_counted() ? contacts_of_[i] : -1;
  grain.radius = atom->radius[i];
  double unwrapped[3];
  domain->unmap(atom->x[i], atom->image[i], unwrapped);
  for (int k = 0; k < 3; ++k) {
    grain.position[k] = atom->x[i][k];
    grain.displacement[k] = unwrapped[k] - track_.start(i)[k];
    grain.rotation[k] = track_.rotation(i)[k];
    grain.velocity[k] = atom->v[i][k];
  }
  return grain;
}

/// On the first rank, by id, so that the file does not depend on the number of ranks; empty on the
/// others.
std::vector<GrainRecord> FixOutputGrains::grains_of_all_ranks() const
{
  std::vector<GrainRecord> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) mine.push_back(record_of(i));
  std::vector<GrainRecord> all = gather_on_first_rank(mine, lmp);
  std::sort(all.begin(), all.end(),
            [](const GrainRecord& a, const GrainRecord& b) { return a.id < b.id; });
  return all;
}

void FixOutputGrains::write()
{
  written_ = true;
  std::vector<GrainRecord> grains = grains_of_all_ranks();
  if (comm->me != 0) return;
  // On the first rank alone, so that the strain does not depend on the number of ranks.
  if (options_.strain) find_strains(grains, strain_range_, box_of(lmp));
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  if (!write_grains(path, grains, options_) || !series_->list(clock_.now(), step))
    files_.stop(path);
}

/// A new grain, and every grain on `reset`, starts where it is. The host calls with -1 on a rank
/// that got none of the grains of `read_data`.
void FixOutputGrains::set_arrays(int i)
{
  if (i < 0) return;
  double unwrapped[3];
  domain->unmap(atom->x[i], atom->image[i], unwrapped);
  track_.begin(i, unwrapped);
}

int FixOutputGrains::pack_restart(int i, double* buffer)
{
  buffer[0] = size_restart(i);
  return 1 + track_.pack(i, buffer + 1);
}

/// The data of all fixes lie one behind the other, each led by its length.
void FixOutputGrains::unpack_restart(int i, int nth)
{
  double* values = atom->extra[i];
  for (int fix = 0; fix < nth; ++fix) values += static_cast<int>(values[0]);
  track_.unpack(i, values + 1);
}

/// The time, then the series.
void FixOutputGrains::write_restart(FILE* file)
{
  if (comm->me == 0) write_block(file, {clock_.now()}, series_->saved());
}

void FixOutputGrains::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    clock_.restart(block.take());
    written_ = *block.text() != '\0';
    if (comm->me == 0 && !series_->restore(block.text()))
      files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
