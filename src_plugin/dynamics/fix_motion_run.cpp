// What the motion takes over from others for the time of a run, when others look at it, and how the
// forces of a step begin.
#include "dynamics/fix_gravity_of_motion.h"
#include "dynamics/fix_motion.h"
#include "host/force_clearing.h"
#include "host/gravity.h"
#include "host/ignores_velocity.h"
#include "host/rank_sums.h"

#include "output.h"

#include <algorithm>

namespace encased_column {

// Of fixes that do not say so nobody knows.
void FixMotion::find_onlookers()
{
  using namespace LAMMPS_NS::FixConst;
  constexpr int in_between = PRE_INITIAL_INTEGRATE | INITIAL_INTEGRATE | ITERATE_IMPLICITLY |
                             PRE_FINAL_INTEGRATE | FINAL_INTEGRATE;
  always_looked_at_ = false;
  looked_at_every_.clear();
  for (int n = 0; n < modify->nfix; ++n) {
    const LAMMPS_NS::Fix* const fix = modify->fix[n];
    if (fix == this || dynamic_cast<const IgnoresVelocity*>(fix)) continue;
    if (modify->fmask[n] & END_OF_STEP) looked_at_every_.push_back(std::max(fix->nevery, 1));
    if (modify->fmask[n] & in_between) always_looked_at_ = true;
  }
}

bool FixMotion::is_looked_at() const
{
  const LAMMPS_NS::bigint step = update->ntimestep;
  if (always_looked_at_ || step == update->laststep || step == output->next) return true;
  return std::any_of(looked_at_every_.begin(), looked_at_every_.end(),
                     [step](int every) { return step % every == 0; });
}

/// True where a fix of the host acts at one of `stages`, up to the fix `last` in the deck's order.
bool FixMotion::others_act(int stages, const LAMMPS_NS::Fix* last) const
{
  for (int n = 0; n < modify->nfix; ++n) {
    const LAMMPS_NS::Fix* const fix = modify->fix[n];
    if (fix == last) return false;
    const bool ours = fix == this || dynamic_cast<const IgnoresVelocity*>(fix) ||
                      dynamic_cast<const ContactProbe*>(fix);
    if (!ours && (modify->fmask[n] & stages)) return true;
  }
  return false;
}

// For the time of one run: the next may be another fix's. Grains outside the group are the host's,
// and what else its integrator clears. Others may add forces before the pairs', or want those
// before the weight. What a `fix gravity` behind this one is like it knows only after its init().
void FixMotion::take_over_sums()
{
  using namespace LAMMPS_NS::FixConst;
  gravity_ = gravity_of(lmp);
  sums_started_ = false;
  const auto gravities = fixes_that_are<FixGravityOfMotion>(lmp);
  starts_sums_ = igroup == 0 && !always_looked_at_ && !others_act(PRE_FORCE, nullptr) &&
                 !neighbor->includegroup && !atom->erforce_flag && !atom->e_flag && !atom->rho_flag;
  takes_weight_ = starts_sums_ && gravities.size() == 1 && gravities.front()->is_plain() &&
                  !others_act(POST_FORCE, gravities.front());
  for (FixGravityOfMotion* gravity : gravities) gravity->leave_weight(takes_weight_);
  ForceClearing::leave_to_us(update->integrate, starts_sums_);
}

void FixMotion::post_run()
{
  finish_step();
  starts_sums_ = takes_weight_ = false;
  ForceClearing::leave_to_us(update->integrate, false);
  for (FixGravityOfMotion* gravity : fixes_that_are<FixGravityOfMotion>(lmp))
    gravity->leave_weight(false);
}

void FixMotion::start_sums(int first, int count)
{
  if (count == 0) return;
  const Vec3 weight = takes_weight_ ? gravity_ : Vec3::Zero();
  double* const __restrict force = atom->f[first];
  double* const __restrict moment = atom->torque[first];
  const double* const __restrict mass = atom->rmass + first;
  for (int i = 0; i < count; ++i)
    for (int a = 0; a < 3; ++a) force[3 * i + a] = mass[i] * weight[a];
  std::fill_n(moment, 3 * count, 0.0);
}

bool FixMotion::wants_contacts(LAMMPS_NS::bigint step) const
{
  return setting_up_ || weighs_new_grains_ || step % every_ == 0;
}

void FixMotion::setup_pre_force(int)
{
  setting_up_ = true;
  take_over_sums();
  anew_ = max_over_ranks(anew_ || made_grains_ ? 1.0 : 0.0, world) > 0.0;
  made_grains_ = false;
  if (time_of_restart_) {  // the host goes on at the step of the file, but at time zero
    update->atime = *time_of_restart_;
    update->atimestep = update->ntimestep;
    time_of_restart_.reset();
  }
  pre_force(0);
}

// Grains that changed their place or rank bring no sums along; new ones come with the same steps,
// and maybe on one rank alone.
void FixMotion::pre_force(int)
{
  mass_scaling.begin_step(moving_grains(), !setting_up_);
  if (neighbor->ago == 0) {
    mass_scaling.admit_new_grains();
    weighs_new_grains_ = max_over_ranks(made_grains_ ? 1.0 : 0.0, world) > 0.0;
    made_grains_ = false;
  }
  if (starts_sums_ && (!sums_started_ || neighbor->ago == 0)) start_sums(0, atom->nlocal);
  sums_started_ = false;
  if (wants_contacts(update->ntimestep)) collect();
}

void FixMotion::collect()
{
  mass_scaling.clear_contacts();
  contact_force_sum_ = contact_count_ = 0.0;
}

void FixMotion::add_contact(const Contact& contact)
{
  mass_scaling.add_contact(contact.i, contact.j, contact.normal, contact.normal_stiffness,
                           contact.shear_stiffness);
  contact_force_sum_ += contact.share * contact.force.norm();
  contact_count_ += contact.share;
}

}  // namespace encased_column
