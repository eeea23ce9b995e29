#pragma once

#include "host/host_types.h"

#include <string>

namespace encased_column {

/// Ends the run where the atoms of the deck have no radius and mass, which `fix` needs.
inline void require_grains(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix& fix)
{
  if (lmp->atom->radius_flag && lmp->atom->rmass_flag) return;
  lmp->error->fix_error(FLERR, &fix,
                        ("'" + std::string(fix.style) +
                         "' needs grains with a radius and a mass, found 'atom_style " +
                         lmp->atom->atom_style + "', write 'atom_style granular'")
                            .c_str());
}

}  // namespace encased_column
