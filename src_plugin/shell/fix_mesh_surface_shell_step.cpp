// What the sleeve does in a step: it moves, and takes the loads of facets, pressure and grains.
#include "shell/fix_mesh_surface_shell.h"

#include "host/rank_sums.h"

namespace encased_column {

namespace {

constexpr int checks_apart = 4;   ///< looks between two checks of the facets
constexpr int bounds_apart = 20;  ///< looks between two bounds of the facets' stiffness

}  // namespace

// Set-up repeats the forces of the step before: what contacts remember stays as it is, and so do
// masses that were made for this length of step.
void FixMeshSurfaceShell::setup(int)
{
  weighing_ = weighed_step_ != update->dt;
  take_loads(false);
  if (!rigid_) close_loads();
}

void FixMeshSurfaceShell::initial_integrate(int)
{
  if (rigid_) return;
  const Platens platens = platens_.now();
  const double inward[2] = {platens.top->speed(), platens.bottom->speed()};
  std::vector<Support>& supports = model_->support();
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const int end = n < first_bottom_support_ ? 0 : 1;
    if (ends_[end] != SleeveEnd::platen) continue;
    supports[n].velocity = Vec3(0.0, 0.0, end == 0 ? -inward[0] : inward[1]);
  }
  const StepWork work = model_->advance(update->dt, damping_);
  pressure_work_ += work.external;
  support_work_ += work.supports;
  damping_loss_ += work.damping;
}

void FixMeshSurfaceShell::take_loads(bool advance_memory)
{
  model_->clear_loads();
  if (rigid_) {
    weighing_ = false;
    weighed_step_ = 0.0;  // a release finds masses anew
    press_grains(advance_memory);
    return;
  }
  energy_ = model_->add_internal_loads(first_, last_);
  if (const double pressure = pressure_now(); pressure != 0.0) {
    add_pressure(model_->facet(), model_->position(), first_, last_, -pressure,
                 everywhere_ ? HeightWindow() : window(), model_->external());
    for (int i = 0; i < model_->nodes(); ++i) model_->force(i) += model_->external()[i];
  }
  if (advance_memory) weighing_ = update->ntimestep % every_ == 0 || weighed_step_ != update->dt;
  if (weighing_) contact_bound_.assign(model_->nodes(), {0.0, 0.0});
  press_grains(advance_memory);
}

void FixMeshSurfaceShell::close_loads()
{
  std::vector<Vec3>& load = model_->load();
  if (comm->nprocs > 1) sum_over_ranks(load.front().data(), 3 * load.size(), world);
  if (weighing_) weigh();
}

void FixMeshSurfaceShell::final_integrate()
{
  if (!rigid_) close_loads();
  if (update->ntimestep % (checks_apart * every_) == 0) check();
}

void FixMeshSurfaceShell::weigh()
{
  const int nodes = model_->nodes();
  if (facet_bound_.empty() || update->ntimestep % (bounds_apart * every_) == 0) {
    facet_bound_.assign(nodes, {0.0, 0.0});
    model_->add_stiffness(first_, last_, facet_bound_);
    sum_over_ranks(&facet_bound_.front().translation, 2 * facet_bound_.size(), world);
  }
  sum_over_ranks(&contact_bound_.front().translation, 2 * contact_bound_.size(), world);
  for (int i = 0; i < nodes; ++i) {
    contact_bound_[i].translation += facet_bound_[i].translation;
    contact_bound_[i].rotation += facet_bound_[i].rotation;
  }
  const bool anew = weighed_step_ != update->dt;
  weighed_step_ = update->dt;
  if (scale_masses_) {
    damping_loss_ += model_->scale_masses(contact_bound_, update->dt, safety_, anew);
    mass_factor_ = model_->mass_factor();
    return;
  }
  const double stable = model_->stable_step(contact_bound_, safety_);
  if (update->dt > stable)
    error->fix_error(
        FLERR, this,
        ("the step of " + in_words(update->dt) + " s is longer than the sleeve's stable " +
         in_words(stable) + " s, write a shorter step or 'mass_scaling yes'")
            .c_str());
}

}  // namespace encased_column
