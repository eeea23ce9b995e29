// What the motion takes over from others for the time of a run, and when others look at it.
#include "dynamics/fix_gravity_of_motion.h"
#include "dynamics/fix_motion.h"
#include "host/blind_to_velocity.h"
#include "host/force_clearing.h"
#include "host/gravity.h"

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
    if (fix == this || dynamic_cast<const BlindToVelocity*>(fix)) continue;
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

// For the time of one run: the next may be another fix's. Grains outside the group are the host's.
// What a `fix gravity` behind this one is like it knows only after its init().
void FixMotion::take_over_sums()
{
  gravity_ = gravity_of(lmp);
  sums_started_ = false;
  const auto gravities = fixes_that_are<FixGravityOfMotion>(lmp);
  starts_sums_ = igroup == 0 && !always_looked_at_;
  takes_weight_ = starts_sums_ && gravities.size() == 1 && gravities.front()->is_plain();
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

}  // namespace encased_column
