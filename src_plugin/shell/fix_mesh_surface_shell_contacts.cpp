// Contacts of the sleeve with the grains.
#include "shell/fix_mesh_surface_shell.h"

#include "host/grain_arrays.h"
#include "host/stop_run.h"

namespace encased_column {

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
    desk_.raise_mass_for_contact(i, action.stiffness);
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

}  // namespace encased_column
