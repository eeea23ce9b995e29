// How the sleeve looks after itself: what stops a run, and what the log gets a warning of.
#include "shell/fix_mesh_surface_shell.h"

#include "host/stop_run.h"

#include <cmath>
#include <limits>

namespace encased_column {

namespace {

/// Distance [m] between platen and end of the sleeve that no grain of a test passes through.
constexpr double end_tolerance = 1e-4;

}  // namespace

void FixMeshSurfaceShell::check()
{
  auto fault = fault_of_facets(*model_, first_, last_, strain_limit_);
  if (!fault && comm->me == 0) fault = fault_of_pairs(*model_, pairs_);
  if (fault)
    stop_from_one_rank(lmp, ("at step " + std::to_string(update->ntimestep) + " " + *fault));
  warn_of_platens_outside();
  warn_of_rupture();
}

void FixMeshSurfaceShell::warn_of_platens_outside()
{
  const double heights[2] = {window().high, window().low};
  for (int n = 0; n < 2; ++n) {
    const double upwards = n == 0 ? 1.0 : -1.0;
    double beyond = std::numeric_limits<double>::infinity();
    for (const int node : end_nodes_[n])
      beyond = std::min(beyond, upwards * (heights[n] - model_->position()[node].z()));
    if (platen_told_[n] || !std::isfinite(heights[n]) || beyond <= end_tolerance) continue;
    platen_told_[n] = true;
    warn("platen '" + platens_.id(n == 0) + "' stands " + in_words(beyond) +
         " m beyond the end of sleeve '" + id + "' at step " + std::to_string(update->ntimestep) +
         ", grains can escape there: hold the platen or make the sleeve longer");
  }
}

void FixMeshSurfaceShell::warn_of_rupture()
{
  if (rupture_ <= 0.0 || rupture_told_) return;
  const double tension = summary().hoop_tension_max;
  if (tension <= rupture_) return;
  rupture_told_ = true;
  warn("the hoop tension of sleeve '" + std::string(id) + "' is " + in_words(tension) +
       " N/m at step " + std::to_string(update->ntimestep) + " and passes its 'rupture' of " +
       in_words(rupture_) + " N/m; it does not tear");
}

void FixMeshSurfaceShell::warn(const std::string& sentence)
{
  if (comm->me == 0) error->warning(FLERR, sentence.c_str());
}

}  // namespace encased_column
