// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "host/find_fix.h"
#include "host/host_types.h"

#include "fix_gravity.h"

namespace encased_column {

/// The host's `fix gravity`, which can leave the weight of the grains to `fix motion`: that one has
/// their forces at hand once a step, and starts their sums with the weight.
class FixGravityOfMotion : public LAMMPS_NS::FixGravity {
 public:
  using FixGravity::FixGravity;

  /// One that never changes and acts on all grains can be left to another fix.
  bool is_plain() const { return varflag == 0 && igroup == 0 && !fm && !fix_relax; }
  /// For the run to come.
  void leave_weight(bool left) { is_left_ = left; }

  void post_force(int flags) override
  {
    was_left_ = is_left_;
    if (!is_left_) FixGravity::post_force(flags);
  }

  /// Potential energy [J], which the host sums up where it applies the force.
  double compute_scalar() override
  {
    if (was_left_) {
      egrav = 0.0;
      eflag = 0;
      for (int i = 0; i < atom->nlocal; ++i)
        egrav -=
            atom->rmass[i] * (xacc * atom->x[i][0] + yacc * atom->x[i][1] + zacc * atom->x[i][2]);
    }
    return FixGravity::compute_scalar();
  }

 private:
  bool is_left_ = false;
  bool was_left_ = false;  ///< when forces were last made
};

/// Acceleration [m/s^2] of the deck's `fix gravity`, zero without one.
inline Vec3 gravity_of(LAMMPS_NS::LAMMPS* lmp)
{
  Vec3 total = Vec3::Zero();
  for (auto* fix : fixes_that_are<LAMMPS_NS::FixGravity>(lmp)) {
    double g[3];
    fix->get_gravity(g);
    total += as_vec3(g);
  }
  return total;
}

}  // namespace encased_column
