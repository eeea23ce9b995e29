// What the sleeve tells others: its shape, forces and energies.
#include "shell/fix_mesh_surface_shell.h"

#include "host/rank_sums.h"
#include "shell/enclosed_volume.h"
#include "shell/level_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

double FixMeshSurfaceShell::compute_vector(int n)
{
  switch (n) {
    case 0:
      return pressure_now();
    case 1:
      return summary().hoop_tension;
    case 2:
      return summary().hoop_tension_max;
    case 3:
      return summary().hoop_strain;
    case 4:
      return summary().hoop_strain_max;
    case 5:
      return axial_force(true);
    case 6:
      return axial_force(false);
    case 7:
      return friction_force();
    case 8:
      return enclosed_volume(window().low, window().high);
    case 9:
      return stored_energy();
    case 10:
      return kinetic_energy();
    case 11:
      return work();
    case 12:
      return damping_loss();
    case 13:
      return mass_factor_;
    default:
      return static_cast<double>(pressure_.steps_left(update->ntimestep));
  }
}

double FixMeshSurfaceShell::level_inside(double z) const
{
  // Where both ends are whole as they are now; not on their nodes, where a platen stands at the
  // start.
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const int node : end_nodes_[0]) high = std::min(high, model_->position()[node].z());
  for (const int node : end_nodes_[1]) low = std::max(low, model_->position()[node].z());
  const double reserve = 1e-6 * (high - low);
  return low < high ? std::clamp(z, low + reserve, high - reserve) : z;
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
  return radius_of_section(cross_section(z));
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
