// SPDX-License-Identifier: GPL-2.0-only
#include "output/fix_output_restart.h"

#include "core/input_error.h"
#include "files/atomic_file.h"
#include "files/restart_seal.h"
#include "host/messages.h"
#include "host/ranks.h"

#include "signal_handling.h"
#include "write_restart.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

namespace encased_column {

const KeywordTable FixOutputRestart::keywords{
    {"every", 1, "steps", "the file is rewritten every so many steps"},
    {"file", 1, "-", "its name"},
};

namespace {

/// False when the bytes of `path` may still be lost with the power.
bool is_on_disk(const std::string& path)
{
  const int file = open(path.c_str(), O_RDONLY);
  if (file < 0) return false;
  const bool done = fsync(file) == 0;
  close(file);
  return done;
}

}  // namespace

FixOutputRestart::FixOutputRestart(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this)
{
  try {
    const Options options = keywords.read(narg, arg);
    nevery = static_cast<int>(options.integer("every", 1));
    file_ = files_.file(options, "file", "", unfinished(""));
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  force_reneighbor = 1;
}

int FixOutputRestart::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | END_OF_STEP | POST_RUN;
}

void FixOutputRestart::init()
{
  try {
    check_order();
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  plan();
}

// What the others do at the end of a step, such as a row of a table, must be in the file.
void FixOutputRestart::check_order() const
{
  for (int n = modify->find_fix(id) + 1; n < modify->nfix; ++n) {
    const LAMMPS_NS::Fix& later = *modify->fix[n];
    const bool acts = (modify->fmask[n] & LAMMPS_NS::FixConst::END_OF_STEP) != 0;
    if (acts && (later.restart_global || later.restart_peratom))
      throw InputError("fix output/restart must stand behind the fixes it saves, found 'fix " +
                       std::string(later.id) + "' of style " + later.style +
                       " behind it, move it to the end");
  }
}

void FixOutputRestart::plan()
{
  next_reneighbor = (update->ntimestep / nevery + 1) * nevery;
}

// The first file is that of the state before the first step.
void FixOutputRestart::setup(int)
{
  if (written_step_ < 0) write();
}

// A run that goes on from the file sorts its grains and builds its lists at this step. So does the
// one that writes it, and stays the same run.
void FixOutputRestart::pre_exchange()
{
  if (update->ntimestep == next_reneighbor && atom->sortfreq > 0)
    atom->nextsort = update->ntimestep;
}

void FixOutputRestart::end_of_step()
{
  write();
  plan();
}

// A signal ends a run between two files. A run that ends as its deck says needs none: the fix of
// the next stage writes one, and going on from the last file ends where this run did.
void FixOutputRestart::post_run()
{
  const double stopped = LAMMPS_NS::SignalHandler::request_quit ? 1.0 : 0.0;
  if (max_over_ranks(stopped, world) > 0.0 && is_old()) write();
}

// Going on from a file of the plan ends where this run would have, on one rank bit by bit: that is
// worth the steps since then, unless they are many.
bool FixOutputRestart::is_old() const
{
  constexpr LAMMPS_NS::bigint steps_to_spare = 5000;
  return update->ntimestep - std::max<LAMMPS_NS::bigint>(written_step_, 0) > steps_to_spare;
}

void FixOutputRestart::write()
{
  std::string part = unfinished(file_);
  LAMMPS_NS::WriteRestart(lmp).write(part.data());
  written_step_ = update->ntimestep;
  if (comm->me == 0 && !(seal_file(part) && is_on_disk(part) && finish_file(file_)))
    files_.stop(file_);
}

}  // namespace encased_column
