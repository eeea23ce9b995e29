#pragma once

#include "host/find_fix.h"
#include "servo/fix_servo_platen.h"

#include <string>

namespace encased_column {

/// The upper and the lower platen that the keyword `platens` names; throws InputError where one is
/// not there or they are the wrong way round.
inline void find_platens(LAMMPS_NS::LAMMPS* lmp, const std::string (&ids)[2],
                         FixServoPlaten* (&platens)[2])
{
  for (int n = 0; n < 2; ++n)
    platens[n] = find_fix<FixServoPlaten>(lmp, "platens", ids[n], "fix servo/platen");
  if (!platens[0]->is_top() || platens[1]->is_top())
    throw InputError("'platens' takes the upper platen first, found '" + ids[0] + " " + ids[1] +
                     "', write the ID of the top and then of the bottom one");
}

}  // namespace encased_column
