// SPDX-License-Identifier: GPL-2.0-only
#include "host/force_start.h"

#include "host/find_fix.h"
#include "host/gravity.h"
#include "host/host_types.h"
#include "host/velocity_watchers.h"

#include "integrate.h"

namespace encased_column {

namespace {

/// Tells the host's integrator whether another clears the sums of forces: it has a switch for that,
/// which only a derived class may set.
struct ForceClearing : LAMMPS_NS::Integrate {
  static void leave_to_us(LAMMPS_NS::Integrate* integrator, bool left)
  {
    integrator->*(&ForceClearing::external_force_clear) = left;
  }
};

}  // namespace

// Grains outside the group are the host's, and what else its integrator clears. Others may add
// forces before the pairs', or want those before the weight. A `fix gravity` that stands behind the
// motion is known only after its init().
void ForceStart::take_over(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion, bool watched)
{
  using namespace LAMMPS_NS::FixConst;
  const LAMMPS_NS::Atom* const atom = lmp->atom;
  gravity_ = gravity_of(lmp);
  const bool ours = motion->igroup == 0 && !watched && !others_act(lmp, motion, PRE_FORCE) &&
                    !lmp->neighbor->includegroup && !atom->erforce_flag && !atom->e_flag &&
                    !atom->rho_flag;
  sums_ = ours ? Sums::ours : Sums::of_host;
  const auto gravities = fixes_that_are<FixGravityOfMotion>(lmp);
  const bool with_weight = ours && gravities.size() == 1 && gravities.front()->is_plain() &&
                           !others_act(lmp, motion, POST_FORCE, gravities.front());
  weight_ = with_weight ? gravity_ : Vec3::Zero();
  for (FixGravityOfMotion* gravity : gravities) gravity->leave_weight(with_weight);
  ForceClearing::leave_to_us(lmp->update->integrate, ours);
}

void ForceStart::give_back(LAMMPS_NS::LAMMPS* lmp)
{
  sums_ = Sums::of_host;
  ForceClearing::leave_to_us(lmp->update->integrate, false);
  for (FixGravityOfMotion* gravity : fixes_that_are<FixGravityOfMotion>(lmp))
    gravity->leave_weight(false);
}

}  // namespace encased_column
