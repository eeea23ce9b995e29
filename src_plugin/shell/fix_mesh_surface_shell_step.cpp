// What the sleeve does in a step: it moves, takes the loads of facets, pressure and grains, and
// looks after itself.
#include "shell/fix_mesh_surface_shell.h"

#include "host/grain_arrays.h"
#include "host/rank_sums.h"
#include "host/stop_run.h"
#include "servo/fix_servo_platen.h"
#include "shell/enclosed_volume.h"
#include "shell/level_cut.h"

#include <cmath>
#include <limits>

namespace encased_column {

namespace {

constexpr int checks_apart = 4;   ///< looks between two checks of the facets
constexpr int bounds_apart = 20;  ///< looks between two bounds of the facets' stiffness
/// Distance [m] between platen and end of the sleeve that no grain of a test passes through.
constexpr double end_tolerance = 1e-4;

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
  std::vector<Support>& supports = model_->support();
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const int end = n < first_bottom_support_ ? 0 : 1;
    if (ends_[end] != SleeveEnd::platen) continue;
    const double inward = platens_[end]->speed();
    supports[n].velocity = Vec3(0.0, 0.0, end == 0 ? -inward : inward);
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

void FixMeshSurfaceShell::press_grains(bool advance_memory)
{
  desk_.ask_probes();
  // Lists of pairs and of facets hold together: grains keep their numbers in between.
  if (neighbor->ago == 0 || contacts_.is_stale(*model_)) {
    contacts_.list(*model_, atom->nlocal ? atom->x[0] : nullptr, atom->radius, atom->nlocal,
                   neighbor->skin);
    remember(contacts_.grains());
  }
  if (rolling_)
    press<true>(advance_memory);
  else
    press<false>(advance_memory);
}

template <bool rolling>
void FixMeshSurfaceShell::press(bool advance_memory)
{
  const double step = static_cast<double>(update->ntimestep);
  vertical_force_ = 0.0;
  if (contacts_.size() == 0) return;
  if (!rigid_) contacts_.look_at(*model_);
  const GrainArrays grains(atom);
  for (int n = 0; n < contacts_.size(); ++n) {
    const int i = contacts_.grain(n);
    const double radius = grains.radius[i];
    const Vec3 center = as_vec3(grains.x + 3 * i);
    if (!(atom->mask[i] & groupbit) || !contacts_.touches(*model_, n, center, radius)) continue;
    if (contacts_.is_behind(*model_))
      stop_from_one_rank(
          lmp, ("grain " + std::to_string(atom->tag[i]) + " is on the wrong side of facet " +
                std::to_string(contacts_.facet()) + " of sleeve '" + id + "' at step " +
                std::to_string(update->ntimestep) +
                ", load more slowly or raise the contact modulus of the sleeve"));
    const SmoothTouch& smooth = contacts_.touch();
    const Vec3 point = center + contact_arm(radius, smooth.overlap) * smooth.normal;
    SurfaceMotion surface{Vec3::Zero(), Vec3::Zero()};
    if (!rigid_) {
      contacts_.take_point(*model_, point);
      surface = contacts_.surface_motion(*model_);
    }
    const Touch touch{smooth.overlap,
                      smooth.normal,
                      grains.mass[i],
                      {radius, as_vec3(grains.v + 3 * i), as_vec3(grains.omega + 3 * i)},
                      {0.0, surface.velocity, surface.spin}};
    const ContactAction action =
        resolve_contact<rolling>(stiffened(desk_.material(grains.type[i], type_), smooth), touch,
                                 update->dt, step, advance_memory, contact_memory(n));
    desk_.bear_wall_contact(i, action.stiffness);
    as_vec3(grains.force + 3 * i) += action.force;
    as_vec3(grains.moment + 3 * i) += action.moment_i;
    const Vec3 shear = -action.force - action.normal_force * smooth.normal;
    if (!rigid_) contacts_.press(*model_, action.normal_force, shear, action.moment_j);
    vertical_force_ -= action.force.z();
    if (weighing_)
      contacts_.add_stiffness(*model_, std::max(action.stiffness.normal, action.stiffness.shear),
                              contact_bound_);
    desk_.book(i, -1, 1.0, advance_memory, touch, action);
  }
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
    warn("platen '" + platen_ids_[n] + "' stands " + in_words(beyond) +
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

double FixMeshSurfaceShell::enclosed_volume(double z_low, double z_high) const
{
  return encased_column::enclosed_volume(model_->facet(), model_->position(), 0, model_->facets(),
                                         {z_low, z_high});
}

double FixMeshSurfaceShell::cross_section(double z) const
{
  return area_at_level(model_->facet(), model_->position(), level_inside(z));
}

double FixMeshSurfaceShell::radius_at(double z) const
{
  return std::sqrt(cross_section(z) / pi);
}

int FixMeshSurfaceShell::count_outside(const double* centers, int count, double z_low,
                                       double z_high) const
{
  const InsideTest sleeve(model_->facet(), model_->position());
  int outside = 0;
  for (const double* x = centers; x != centers + 3 * count; x += 3)
    outside += x[2] < z_low || x[2] > z_high || !sleeve.is_inside(as_vec3(x));
  return outside;
}

double FixMeshSurfaceShell::work() const
{
  return sum_over_ranks(pressure_work_, world) + support_work_;
}

double FixMeshSurfaceShell::stored_energy() const
{
  return sum_over_ranks(energy_, world);
}

double FixMeshSurfaceShell::kinetic_energy() const
{
  return model_->kinetic_energy();
}

double FixMeshSurfaceShell::axial_force(bool top) const
{
  const std::vector<Support>& supports = model_->support();
  double sum = 0.0;
  for (std::size_t n = 0; n < supports.size(); ++n)
    if ((n < first_bottom_support_) == top) sum += supports[n].force.z();
  return sum;
}

double FixMeshSurfaceShell::friction_force() const
{
  return sum_over_ranks(vertical_force_, world);
}

}  // namespace encased_column
