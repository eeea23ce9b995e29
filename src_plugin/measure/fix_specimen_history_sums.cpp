// What `fix specimen/history` adds up over contacts and grains, and what must hold for them.
#include "measure/fix_specimen_history.h"

#include "dynamics/fix_motion.h"
#include "dynamics/kinetic_energy.h"
#include "host/gravity.h"
#include "host/rank_sums.h"
#include "measure/love_weber.h"
#include "measure/sphere_overlap.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

void FixSpecimenHistory::clear_sums()
{
  contacts_of_.assign(atom->nlocal, 0);
  shared_volume_ = elastic_ = 0.0;
  core_heights_ = specimen().window().middle_third();
  core_ = CoreStress();
}

void FixSpecimenHistory::add_contact(const Contact& contact)
{
  const double radius = atom->radius[contact.i];
  ++contacts_of_[contact.i];
  if (contact.j >= 0 && contact.j < atom->nlocal) ++contacts_of_[contact.j];
  const double volume =
      contact.j < 0 ? sphere_cap_volume(radius, contact.length)
                    : sphere_overlap_volume(radius, atom->radius[contact.j], contact.length);
  add_to_core(contact.i, contact.arm * contact.normal, contact.force);
  if (contact.j >= 0 && contact.j < atom->nlocal)
    add_to_core(contact.j, -(contact.length - contact.arm) * contact.normal, -contact.force);
  shared_volume_ += contact.share * volume;
  elastic_ += contact.share * contact.stored_energy;
}

void FixSpecimenHistory::add_to_core(int i, const Vec3& lever, const Vec3& force)
{
  if (!is_in_core(i)) return;
  const Vec3 outward = specimen().outward(as_vec3(atom->x[i]));
  core_.axial += love_weber(force, lever, Vec3::UnitZ());
  core_.radial += love_weber(force, lever, outward);
}

FixSpecimenHistory::Sums FixSpecimenHistory::sum_up()
{
  Sums sums{};
  const Vec3 gravity = gravity_of(lmp);
  for (int i = 0; i < atom->nlocal; ++i) {
    const double r = atom->radius[i];
    const double inertia = motion_->inertial_mass(i);
    sums.grains += 1.0;
    sums.solid += sphere_volume(r);
    sums.inertia += inertia;
    sums.mass += atom->rmass[i];
    sums.diameter += 2.0 * r * atom->rmass[i];
    sums.weight_height += atom->rmass[i] * gravity.dot(as_vec3(atom->x[i]));
    sums.kinetic += kinetic_energy(inertia, r, as_vec3(atom->v[i]), as_vec3(atom->omega[i]));
    if (is_in_core(i)) sums.core_solid += sphere_volume(r);
    if (contacts_of_[i] == 0) sums.without_contact += 1.0;
    if (contacts_of_[i] == 1) sums.with_one_contact += 1.0;
    sums.ends += contacts_of_[i];
  }
  sums.core_axial = core_.axial;
  sums.core_radial = core_.radial;
  sums.shared = shared_volume_;
  sums.elastic = elastic_;
  sums.friction = contact_losses.friction;
  sums.rolling = contact_losses.rolling;
  sums.dashpots = contact_losses.dashpots;
  sum_over_ranks(&sums.grains, sizeof(Sums) / sizeof(double), world);
  return sums;
}

// A grain that left, or a number that is none, must not pass for a result.
void FixSpecimenHistory::check_grains(const Sums& sums)
{
  if (!std::isfinite(sums.kinetic) || !std::isfinite(sums.elastic))
    error->fix_error(
        FLERR, this,
        ("the energy of the grains is not a number at step " + std::to_string(update->ntimestep) +
         ", go back to the last restart file with a smaller step")
            .c_str());
  // The host's own count forgets grains that `thermo_modify lost ignore` lets go.
  const auto grains = static_cast<LAMMPS_NS::bigint>(sums.grains);
  most_grains_ = std::max(most_grains_, grains);
  if (grains < most_grains_)
    error->fix_error(FLERR, this,
                     ("of " + std::to_string(most_grains_) + " grains " + std::to_string(grains) +
                      " are left at step " + std::to_string(update->ntimestep) +
                      ", enlarge the box or slow the walls")
                         .c_str());
  const double outside = sum_over_ranks(
      atom->nlocal == 0 ? 0.0 : specimen().count_outside(atom->x[0], atom->nlocal), world);
  if (outside > 0.0)
    error->fix_error(
        FLERR, this,
        (std::to_string(static_cast<long>(outside)) + " grains are outside the walls at step " +
         std::to_string(update->ntimestep) +
         (update->ntimestep == update->firststep
              ? ", where the run begins, and all grains of the box count as one specimen: delete "
                "those that do not belong to it or set the walls about them"
              : ", slow the walls or raise the contact modulus"))
            .c_str());
}

}  // namespace encased_column
