#pragma once

#include "host/host_types.h"

namespace encased_column {

/// Throws InputError where contacts would not follow the linear law: `needs_it` in the deck, such
/// as "fix move of style motion", reads its stiffness and its springs, and takes what another law
/// makes of a contact for nothing. Walls of the host are looked at too.
void require_linear_law(LAMMPS_NS::LAMMPS* lmp, const std::string& needs_it);

}  // namespace encased_column
