// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/solve_command.h"

#include "core/input_error.h"
#include "dynamics/fix_motion.h"
#include "host/find_fix.h"

#include "integrate.h"
#include "output.h"
#include "signal_handling.h"
#include "timer.h"

#include <algorithm>
#include <optional>

namespace encased_column {

const KeywordTable SolveCommand::keywords{
    {"ratio", 2, "-",
     "which unbalanced force ratio, `average`, `maximum` or `bearing`, and its limit"},
    {"every", 1, "steps",
     "how often it is looked at, a multiple of the motion's `every` (default 200)"},
    {"max", 1, "steps", "after so many the run stops with an error (default 200000)"},
    {"least", 1, "steps", "at least so many are run (default 0)"},
    {"damping", 1, "-",
     "local damping alpha once `least` steps are run, 0 to 0.99 (default: the motion's)"},
};

namespace {

double chosen(const UnbalancedForceRatio& ratio, const std::string& which)
{
  return which == "average" ? ratio.average : which == "maximum" ? ratio.maximum : ratio.bearing;
}

/// True when a signal ends the run and its restart file is written: one that comes between two
/// pieces of the run waits for the next step to write it.
bool is_stopped()
{
  return LAMMPS_NS::SignalHandler::request_quit && !LAMMPS_NS::SignalHandler::request_write_restart;
}

}  // namespace

void SolveCommand::command(int narg, char** arg)
{
  std::string which;
  double limit = 0.0;
  long every = 0, max = 0, least = 0;
  std::optional<double> damping;
  FixMotion* motion = nullptr;
  try {
    const Options options = keywords.read(narg, arg, 0);
    which = options.choice("ratio", {"average", "maximum", "bearing"});
    limit = read_number("ratio", options.all("ratio").front()[1]);
    if (!(limit > 0.0))
      throw InputError("'ratio' takes a limit larger than zero, found " + in_words(limit) +
                       ", write 'ratio average 1e-5'");
    every = options.integer("every", 1, 200);
    max = options.integer("max", 1, 200000);
    least = options.integer("least", 0, 0);
    if (options.has("damping")) damping = options.between("damping", 0.0, 0.99);
    if (least > max)
      throw InputError("'least' must not be larger than 'max', found " + std::to_string(least) +
                       " and " + std::to_string(max) + ", write a larger 'max'");
    if (domain->box_exist == 0)
      throw InputError(
          "'solve' must stand behind the command that makes the box, found no box yet, write "
          "'create_box' or 'read_restart' before it");
    const auto motions = fixes_that_are<FixMotion>(lmp);
    if (motions.size() != 1)
      throw InputError("'solve' needs one 'fix motion', found " + std::to_string(motions.size()) +
                       ", write 'fix move all motion' before it");
    motion = motions.front();
    const long unit = motion->every();
    if (every % unit != 0)
      throw InputError("'every' must be a multiple of the 'every' of fix " +
                       std::string(motion->id) + ", found " + std::to_string(every) + " and " +
                       std::to_string(unit) + ", write for example 'every " +
                       std::to_string(std::max(every / unit, 1L) * unit) + "'");
  } catch (const InputError& problem) {
    error->all(FLERR, problem.what());
  }

  // As the host's `run`, in pieces of `every` steps with one set-up.
  const LAMMPS_NS::bigint end = update->ntimestep + max;
  update->whichflag = 1;
  update->nsteps = static_cast<int>(max);
  update->firststep = update->beginstep = update->ntimestep;
  update->laststep = update->endstep = end;
  lmp->init();
  update->integrate->setup();
  timer->init();
  timer->barrier_start(TIME_LOOP);
  long done = 0;
  double ratio = 1.0;
  bool is_reached = false;
  while (done < max && !is_stopped() && !is_reached) {
    // Pieces end where the motion has just updated masses and ratios.
    const long piece = std::min(every - static_cast<long>(update->ntimestep % every), max - done);
    // A run that goes on from a restart file has what is left of `least`: both come to one step.
    if (damping && done < least && least < done + piece) {
      update->integrate->run(static_cast<int>(least - done));
      done = least;
      continue;
    }
    if (damping && done >= least) motion->damp_run_with(*damping);
    run_piece(piece);
    done += piece;
    ratio = chosen(motion->unbalanced_ratio(), which);
    is_reached = ratio <= limit && done >= least;
    if (is_reached)
      write_last_output();
    else
      go_on(end);
  }
  timer->barrier_stop(TIME_LOOP);
  update->integrate->cleanup();
  update->whichflag = 0;
  update->firststep = update->laststep = 0;
  update->beginstep = update->endstep = 0;

  report(motion->unbalanced_ratio(), limit, which, done);
  if (!(ratio <= limit) && !LAMMPS_NS::SignalHandler::request_quit)
    error->all(FLERR, ("'ratio' " + which + " " + in_words(limit) + " was not reached in " +
                       std::to_string(done) + " steps, found " + in_words(ratio) +
                       ", write a larger 'max' or look at what still moves")
                          .c_str());
}

// Whether a step was the last is known only after it: the one at the end of a piece counts as the
// last while it is made, so that fixes that write or measure at the end of a run act.
void SolveCommand::run_piece(long steps)
{
  if (steps > 1) update->integrate->run(static_cast<int>(steps - 1));
  if (is_stopped()) return;
  update->laststep = update->ntimestep + 1;
  modify->addstep_compute_all(update->laststep);
  update->integrate->run(1);
}

/// The last line of the host's table, and what it looks at for it, such as grains that left.
void SolveCommand::write_last_output()
{
  if (output->last_thermo == update->ntimestep) return;
  output->next_thermo = output->next = update->ntimestep;
  output->write(update->ntimestep);
}

/// The step that was made was not the last one: what was planned for it comes at its own time.
void SolveCommand::go_on(LAMMPS_NS::bigint end)
{
  update->laststep = end;
  if (update->ntimestep == end || output->next > update->ntimestep) return;
  ++update->ntimestep;
  output->reset_timestep(update->ntimestep);
  --update->ntimestep;
}

void SolveCommand::report(const UnbalancedForceRatio& ratio, double limit, const std::string& which,
                          long steps) const
{
  if (comm->me != 0) return;
  for (FILE* out : {screen, logfile})
    if (out)
      fprintf(
          out,
          "solve: %s unbalanced force ratio %.3g (limit %.3g) after %ld steps; average over all "
          "grains %.3g, with those that bear no load as balanced %.3g\n",
          which.c_str(), chosen(ratio, which), limit, steps, ratio.average, ratio.bearing);
}

}  // namespace encased_column
