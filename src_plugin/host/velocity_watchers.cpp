// SPDX-License-Identifier: GPL-2.0-only
#include "host/velocity_watchers.h"

#include "host/contact_observer.h"

#include "output.h"

#include <algorithm>

namespace encased_column {

bool others_act(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion, int stages,
                const LAMMPS_NS::Fix* last)
{
  for (int n = 0; n < lmp->modify->nfix; ++n) {
    const LAMMPS_NS::Fix* const fix = lmp->modify->fix[n];
    if (fix == last) return false;
    const bool ours = fix == motion || dynamic_cast<const IgnoresVelocity*>(fix) ||
                      dynamic_cast<const ContactObserver*>(fix);
    if (!ours && (lmp->modify->fmask[n] & stages)) return true;
  }
  return false;
}

void VelocityWatchers::find(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion)
{
  using namespace LAMMPS_NS::FixConst;
  constexpr int in_between = PRE_INITIAL_INTEGRATE | INITIAL_INTEGRATE | ITERATE_IMPLICITLY |
                             PRE_FINAL_INTEGRATE | FINAL_INTEGRATE;
  look_always_ = false;
  every_.clear();
  for (int n = 0; n < lmp->modify->nfix; ++n) {
    const LAMMPS_NS::Fix* const fix = lmp->modify->fix[n];
    if (fix == motion || dynamic_cast<const IgnoresVelocity*>(fix)) continue;
    if (lmp->modify->fmask[n] & END_OF_STEP) every_.push_back(std::max(fix->nevery, 1));
    if (lmp->modify->fmask[n] & in_between) look_always_ = true;
  }
}

bool VelocityWatchers::look_now(LAMMPS_NS::LAMMPS* lmp) const
{
  const LAMMPS_NS::bigint step = lmp->update->ntimestep;
  if (look_always_ || step == lmp->update->laststep || step == lmp->output->next) return true;
  return std::any_of(every_.begin(), every_.end(), [step](int every) { return step % every == 0; });
}

}  // namespace encased_column
