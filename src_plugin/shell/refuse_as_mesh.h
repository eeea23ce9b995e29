// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <string>
#include <vector>

namespace encased_column {

/// Fixes of the host that take the ID of a mesh. (`fix wall/gran` is not among them: a sleeve among
/// its meshes has a meaning, see make_wall().)
std::vector<std::string> fixes_that_take_meshes();

/// Ends the run with a sentence where a command of the host, with the words of a `fix` or `dump`
/// line, names a sleeve as a mesh: the host casts whatever bears the name to a mesh of its own.
void refuse_sleeve_as_mesh(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

}  // namespace encased_column
