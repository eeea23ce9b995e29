#pragma once

#include "core/vec3.h"

namespace encased_column {

/// What the force [N] on a grain at `lever` [m] from its center adds to V times the stress along
/// the unit vector `direction` [J], positive in compression.
///
/// Love-Weber: V sigma = - sum over contacts of force x lever; in equilibrium the mean stress of
/// the grain. Source: Weber, Bull. Liaison Ponts et Chaussees 20 (1966) 3-1 to 3-20.
inline double love_weber(const Vec3& force, const Vec3& lever, const Vec3& direction)
{
  return -force.dot(direction) * lever.dot(direction);
}

}  // namespace encased_column
