#pragma once

#include "core/input_error.h"
#include "host/host_types.h"

#include <string>

namespace encased_column {

/// The fix that `keyword` names by its ID, as a T; throws InputError when there is none or when it
/// is of another kind. `kind` says in words what is wanted.
template <typename T>
T* find_fix(LAMMPS_NS::LAMMPS* lmp, const std::string& keyword, const std::string& id,
            const std::string& kind)
{
  const int n = lmp->modify->find_fix(id.c_str());
  if (n < 0)
    throw InputError("'" + keyword + "' must name a " + kind + ", found '" + id +
                     "' and no fix has that ID, define it before");
  auto* fix = dynamic_cast<T*>(lmp->modify->fix[n]);
  if (!fix)
    throw InputError("'" + keyword + "' must name a " + kind + ", found '" + id +
                     "', which is a 'fix " + lmp->modify->fix[n]->style + "', write the ID of a " +
                     kind);
  return fix;
}

/// True where `known` still is one of the deck's fixes; `unfix` leaves such a pointer dangling.
template <typename T>
bool is_there(LAMMPS_NS::LAMMPS* lmp, const T* known)
{
  for (int n = 0; n < lmp->modify->nfix; ++n)
    if (known && dynamic_cast<T*>(lmp->modify->fix[n]) == known) return true;
  return false;
}

}  // namespace encased_column
