#pragma once

#include "core/vec3.h"
#include "host/contact_observer.h"

#include "fix_gravity.h"

namespace encased_column {

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
